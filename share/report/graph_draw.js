// The map's graph: its joints as data, and how they are drawn at any size.
import {context} from "./dom.js";

const ground = "#10131b";
const path_colour = "#4d586d";
const node_colour = "#aab6cc";
const colour_steps = 24;

// Loops by the nodes they join. A loop that moved from a node to itself is a mark on that node.
export function loopJoints(store) {
  const {history, loops, graph} = store.data;
  const begins = new Set(store.data.sessions ?? [0]); // no way leads to the first image of a session
  const joined = new Map();
  for (let k = 0; k < loops.image.length; ++k) {
    const image = loops.image[k];
    const to = history.node[image];
    const from = begins.has(image) || image === 0 ? to : history.node[image - 1];
    const key = Math.min(from, to) * graph.nodes + Math.max(from, to);
    const joint = joined.get(key);
    if (!joint) joined.set(key, {from, to, loops: [k], best: loops.score[k]});
    else {
      joint.loops.push(k);
      joint.best = Math.max(joint.best, loops.score[k]);
    }
  }
  // The strongest are drawn last, on top.
  return [...joined.values()].sort((a, b) => a.best - b.best);
}

// Points thinned to one a cell of `cell` pixels, of those on the canvas: their numbers.
export function visible(at, zoom, cell) {
  const width = zoom.canvas.clientWidth;
  const height = zoom.canvas.clientHeight;
  const taken = new Set();
  const out = [];
  for (let i = 0; i < at.length / 2; ++i) {
    const x = zoom.toX(at[2 * i]);
    const y = zoom.toY(at[2 * i + 1]);
    if (x < -20 || y < -20 || x > width + 20 || y > height + 20) continue;
    const key = Math.floor(x / cell) * 100003 + Math.floor(y / cell);
    if (taken.has(key)) continue;
    taken.add(key);
    out.push(i);
  }
  return out;
}

function strokeEdges(c, zoom, at, pairs) {
  c.beginPath();
  for (let i = 0; i < pairs.length; i += 2) {
    const a = 2 * pairs[i];
    const b = 2 * pairs[i + 1];
    c.moveTo(zoom.toX(at[a]), zoom.toY(at[a + 1]));
    c.lineTo(zoom.toX(at[b]), zoom.toY(at[b + 1]));
  }
  c.stroke();
}

// Loops in steps of colour, each one path: thousands of single strokes would be slow.
function strokeLoops(c, zoom, at, joints, scale, width) {
  const steps = new Map();
  for (const joint of joints) {
    const step = Math.round(scale.part(joint.best) * colour_steps);
    if (!steps.has(step)) steps.set(step, []);
    steps.get(step).push(joint);
  }
  for (const [step, list] of [...steps].sort((a, b) => a[0] - b[0])) {
    c.strokeStyle = scale.colour(scale.low + (step / colour_steps) * (scale.high - scale.low));
    c.lineWidth = width;
    strokeEdges(c, zoom, at, list.flatMap(({from, to}) => (from === to ? [] : [from, to])));
    for (const {from, to} of list) {
      if (from !== to) continue;
      c.beginPath();
      c.arc(zoom.toX(at[2 * to]), zoom.toY(at[2 * to + 1]), 2.5 * width, 0, 7);
      c.stroke();
    }
  }
}

function drawLabels(c, zoom, at, radius) {
  c.font = "11px system-ui, sans-serif";
  c.textBaseline = "middle";
  const placed = []; // no label over another
  for (const i of visible(at, zoom, 40)) {
    const x = zoom.toX(at[2 * i]) + radius + 4;
    const y = zoom.toY(at[2 * i + 1]) - 8;
    const width = 8 * String(i).length + 10;
    if (placed.some((p) => Math.abs(p.y - y) < 22 && x < p.x + p.width && p.x < x + width)) continue;
    placed.push({x, y, width});
    c.strokeStyle = ground;
    c.lineWidth = 3;
    c.strokeText(String(i), x, y);
    c.fillStyle = "#c3ccdc";
    c.fillText(String(i), x, y);
  }
}

function ring(c, x, y, radius, colour, width) {
  c.beginPath();
  c.arc(x, y, radius, 0, 7);
  c.strokeStyle = colour;
  c.lineWidth = width;
  c.stroke();
}

// `picture`: {at: [x, y, ...] of the nodes, graph, joints, scale, selected: joint or null, node: number or null}
export function drawGraph(zoom, picture) {
  const {c, width, height} = context(zoom.canvas);
  const {at, graph, joints, scale} = picture;
  c.fillStyle = ground;
  c.fillRect(0, 0, width, height);
  if (at.length === 0) return;
  c.lineCap = "round";
  const crowd = Math.sqrt((width * height) / Math.max(1, at.length / 2)); // pixels a node has at the whole map
  const size = crowd * (zoom.scale / zoom.fitScale());
  const radius = Math.min(6.5, Math.max(1.1, size / 9));
  c.strokeStyle = path_colour;
  c.lineWidth = Math.min(5, Math.max(0.8, radius * 0.9));
  strokeEdges(c, zoom, at, graph.paths);
  strokeLoops(c, zoom, at, joints, scale, Math.min(3, Math.max(1.2, radius * 0.55)));
  c.fillStyle = node_colour;
  for (const i of visible(at, zoom, Math.max(2, radius))) {
    const x = zoom.toX(at[2 * i]);
    const y = zoom.toY(at[2 * i + 1]);
    if (radius < 1.6) c.fillRect(x - radius / 2, y - radius / 2, radius, radius);
    else {
      c.beginPath();
      c.arc(x, y, radius, 0, 7);
      c.fill();
    }
  }
  drawLabels(c, zoom, at, radius);
  if (graph.active >= 0 && 2 * graph.active < at.length) {
    ring(c, zoom.toX(at[2 * graph.active]), zoom.toY(at[2 * graph.active + 1]), radius + 3.5, "#ffffff", 1.6);
  }
  drawSelection(c, zoom, picture, radius);
}

function drawSelection(c, zoom, {at, selected, node, scale}, radius) {
  if (selected) {
    for (const [colour, width] of [["#ffffff", 8], [scale.colour(selected.best), 4]]) {
      c.strokeStyle = colour;
      c.lineWidth = width;
      strokeEdges(c, zoom, at, [selected.from, selected.to]);
    }
  }
  const rings = selected ? [selected.from, selected.to] : [];
  if (node !== null) rings.push(node);
  for (const i of rings) {
    ring(c, zoom.toX(at[2 * i]), zoom.toY(at[2 * i + 1]), radius + 6, ground, 5);
    ring(c, zoom.toX(at[2 * i]), zoom.toY(at[2 * i + 1]), radius + 6, "#ffffff", 2.5);
  }
}

function distanceToSegment(px, py, ax, ay, bx, by) {
  const length = (bx - ax) ** 2 + (by - ay) ** 2;
  const t = length > 0 ? Math.min(1, Math.max(0, ((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / length)) : 0;
  return Math.hypot(px - ax - t * (bx - ax), py - ay - t * (by - ay));
}

// What is at canvas pixels (px, py): {node}, {joint} or null.
export function hit(zoom, at, joints, px, py) {
  let node = null;
  let nearest = 13;
  for (let i = 0; i < at.length / 2; ++i) {
    const distance = Math.hypot(zoom.toX(at[2 * i]) - px, zoom.toY(at[2 * i + 1]) - py);
    if (distance < nearest) {
      nearest = distance;
      node = i;
    }
  }
  let joint = null;
  let beside = 6;
  for (const candidate of joints) {
    const [a, b] = [2 * candidate.from, 2 * candidate.to];
    const distance = distanceToSegment(
      px, py, zoom.toX(at[a]), zoom.toY(at[a + 1]), zoom.toX(at[b]), zoom.toY(at[b + 1]));
    if (distance < beside) {
      beside = distance;
      joint = candidate;
    }
  }
  // A node's own disk wins; between nodes the line does.
  if (node !== null && (nearest < 7 || joint === null)) return {node};
  return joint === null ? null : {joint};
}
