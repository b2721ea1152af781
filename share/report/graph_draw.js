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

// The nodes on the canvas, and the length of a usual way between two, all in pixels.
class Projection {
  constructor(zoom, at, paths) {
    this.width = zoom.canvas.clientWidth;
    this.height = zoom.canvas.clientHeight;
    this.count = at.length / 2;
    this.x = new Float32Array(this.count);
    this.y = new Float32Array(this.count);
    for (let i = 0; i < this.count; ++i) {
      this.x[i] = zoom.toX(at[2 * i]);
      this.y[i] = zoom.toY(at[2 * i + 1]);
    }
    this.way = this.usualWay(paths);
  }

  // The median of some.
  usualWay(paths) {
    const lengths = [];
    const step = 2 * Math.max(1, Math.floor(paths.length / 400));
    for (let i = 0; i + 1 < paths.length; i += step) {
      lengths.push(Math.hypot(this.x[paths[i]] - this.x[paths[i + 1]], this.y[paths[i]] - this.y[paths[i + 1]]));
    }
    lengths.sort((a, b) => a - b);
    return lengths.length ? lengths[lengths.length >> 1] : 60;
  }

  // Nodes in sight, thinned to one a cell of so many pixels.
  visible(cell) {
    const taken = new Set();
    const out = [];
    for (let i = 0; i < this.count; ++i) {
      const x = this.x[i];
      const y = this.y[i];
      if (x < -20 || y < -20 || x > this.width + 20 || y > this.height + 20) continue;
      const key = Math.floor(x / cell) * 100003 + Math.floor(y / cell);
      if (taken.has(key)) continue;
      taken.add(key);
      out.push(i);
    }
    return out;
  }

  // Whether a line from a to b may cross the canvas.
  mayCross(a, b) {
    const [x, y, room] = [this.x, this.y, 10];
    return !(
      (x[a] < -room && x[b] < -room) || (y[a] < -room && y[b] < -room) ||
      (x[a] > this.width + room && x[b] > this.width + room) ||
      (y[a] > this.height + room && y[b] > this.height + room));
  }

  line(c, a, b) {
    if (!this.mayCross(a, b)) return;
    c.moveTo(this.x[a], this.y[a]);
    c.lineTo(this.x[b], this.y[b]);
  }
}

function strokePaths(c, nodes, pairs) {
  c.beginPath();
  for (let i = 0; i < pairs.length; i += 2) nodes.line(c, pairs[i], pairs[i + 1]);
  c.stroke();
}

// Loops in steps of colour, each one path: thousands of single strokes would be slow. Weak ones first.
function strokeLoops(c, nodes, joints, scale, width) {
  const steps = Array.from({length: colour_steps + 1}, () => []);
  for (const joint of joints) steps[Math.round(scale.part(joint.best) * colour_steps)].push(joint);
  c.lineWidth = width;
  steps.forEach((list, step) => {
    if (list.length === 0) return;
    c.strokeStyle = scale.colour(scale.low + (step / colour_steps) * (scale.high - scale.low));
    c.beginPath();
    for (const {from, to} of list) {
      if (from !== to) nodes.line(c, from, to);
      else if (nodes.mayCross(from, to)) {
        c.moveTo(nodes.x[to] + 2.5 * width, nodes.y[to]);
        c.arc(nodes.x[to], nodes.y[to], 2.5 * width, 0, 7);
      }
    }
    c.stroke();
  });
}

function drawDots(c, nodes, radius) {
  c.fillStyle = node_colour;
  for (const i of nodes.visible(Math.max(2, radius))) {
    const [x, y] = [nodes.x[i], nodes.y[i]];
    if (radius < 1.6) c.fillRect(x - radius / 2, y - radius / 2, radius, radius);
    else {
      c.beginPath();
      c.arc(x, y, radius, 0, 7);
      c.fill();
    }
  }
}

function drawLabels(c, nodes, radius) {
  c.font = "11px system-ui, sans-serif";
  c.textBaseline = "middle";
  const placed = []; // no label over another
  for (const i of nodes.visible(40)) {
    const x = nodes.x[i] + radius + 4;
    const y = nodes.y[i] - 8;
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
  const nodes = new Projection(zoom, at, graph.paths);
  const radius = Math.min(6.5, Math.max(1.1, nodes.way / 5));
  c.lineCap = radius > 2 ? "round" : "butt";
  c.strokeStyle = path_colour;
  c.lineWidth = Math.min(5, Math.max(0.8, radius * 0.9));
  strokePaths(c, nodes, graph.paths);
  strokeLoops(c, nodes, joints, scale, Math.min(3, Math.max(1.2, radius * 0.55)));
  drawDots(c, nodes, radius);
  drawLabels(c, nodes, radius);
  if (graph.active >= 0 && graph.active < nodes.count) {
    ring(c, nodes.x[graph.active], nodes.y[graph.active], radius + 3.5, "#ffffff", 1.6);
  }
  drawSelection(c, nodes, picture, radius);
}

function drawSelection(c, nodes, {selected, node, scale}, radius) {
  if (selected) {
    for (const [colour, width] of [["#ffffff", 8], [scale.colour(selected.best), 4]]) {
      c.strokeStyle = colour;
      c.lineWidth = width;
      strokePaths(c, nodes, [selected.from, selected.to]);
    }
  }
  const rings = selected ? [selected.from, selected.to] : [];
  if (node !== null) rings.push(node);
  for (const i of rings) {
    ring(c, nodes.x[i], nodes.y[i], radius + 6, ground, 5);
    ring(c, nodes.x[i], nodes.y[i], radius + 6, "#ffffff", 2.5);
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
