// Section "Map": the graph, and what is known of the node or loop that was clicked.
import {button, el, image, redrawn, section} from "./dom.js";
import {drawScale} from "./colours.js";
import {count, number, score} from "./format.js";
import {drawGraph, hit, loopJoints} from "./graph_draw.js";
import {Zoom} from "./zoom.js";

const loops_listed = 12; // of a node

export class MapView {
  constructor(store) {
    this.store = store;
    this.places = "layout";
    this.node = null;
    this.canvas = el("canvas", {
      class: "graph",
      tabindex: "0",
      role: "img",
      "aria-describedby": "map-keys",
    });
    this.bubble = el("div", {class: "bubble", "aria-live": "polite", hidden: true});
    this.zoom = new Zoom(this.canvas, {
      bounds: () => this.bounds(),
      changed: () => this.redraw(),
      tapped: (x, y) => this.tap(x, y),
    });
    this.redraw = redrawn(this.canvas, () => this.draw());
    this.low = el("span");
    this.high = el("span");
    this.build();
    this.refresh();
    store.on("data", () => this.refresh());
    store.on("loop", () => this.showLoop());
  }

  build() {
    const scale = el("canvas", {"aria-hidden": "true"});
    drawScale(scale);
    const tools = el(
      "div",
      {class: "tools", role: "group", "aria-label": "View of the map"},
      this.placeButtons(),
      button("+", () => this.zoom.by(1.5), {"aria-label": "Zoom in"}),
      button("−", () => this.zoom.by(1 / 1.5), {"aria-label": "Zoom out"}),
      button("Fit", () => this.zoom.fit(), {"aria-label": "Show the whole map"}),
    );
    const legend = el(
      "div",
      {class: "legend"},
      el("span", {class: "scale"}, "Loop similarity", this.low, scale, this.high),
      el("span", {}, "grey: the way that was travelled"),
      el("span", {}, "white ring: last place"),
      el("span", {class: "hint", id: "map-keys"}, "Drag, pinch or wheel; keys: arrows, +, −, 0"),
    );
    section(
      "map",
      "Map",
      "Each dot is a place, each line a way between two. Coloured lines are loop closures: click one, or a dot.",
      el("div", {class: "stage"}, this.canvas, tools, this.bubble, legend),
    );
  }

  placeButtons() {
    if (!this.store.data.graph.positions) return [];
    const buttons = [["layout", "Graph"], ["positions", "Positions"]].map(([places, text]) =>
      button(text, () => {
        this.places = places;
        for (const other of buttons) other.setAttribute("aria-pressed", String(other.textContent === text));
        this.zoom.fit();
      }, {"aria-pressed": String(places === this.places)}));
    return buttons;
  }

  refresh() {
    const {graph} = this.store.data;
    this.joints = loopJoints(this.store);
    this.jointOfLoop = new Map(this.joints.flatMap((joint) => joint.loops.map((loop) => [loop, joint])));
    this.canvas.setAttribute(
      "aria-label",
      `Topological map: ${count(graph.nodes, "place")}, ${count(this.store.loopCount, "loop closure")}`);
    this.low.textContent = score(this.store.scale.low);
    this.high.textContent = `${score(this.store.scale.high)} and above`;
    if (!this.zoom.touched) this.zoom.fit();
    this.redraw();
  }

  get at() {
    return this.store.data.graph[this.places] ?? [];
  }

  bounds() {
    let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
    const at = this.at;
    for (let i = 0; i < at.length; i += 2) {
      x0 = Math.min(x0, at[i]);
      x1 = Math.max(x1, at[i]);
      y0 = Math.min(y0, at[i + 1]);
      y1 = Math.max(y1, at[i + 1]);
    }
    return at.length ? {x0, y0, x1, y1} : {x0: 0, y0: 0, x1: 1, y1: 1};
  }

  draw() {
    if (!this.zoom.touched && this.fitted !== this.canvas.clientWidth) {
      this.fitted = this.canvas.clientWidth;
      this.zoom.fit();
    }
    drawGraph(this.zoom, {
      at: this.at,
      graph: this.store.data.graph,
      joints: this.joints,
      scale: this.store.scale,
      selected: this.jointOf(this.store.loop),
      node: this.node,
    });
  }

  jointOf(loop) {
    return loop === null ? null : this.jointOfLoop.get(loop) ?? null;
  }

  tap(x, y) {
    const found = hit(this.zoom, this.at, this.joints, x, y);
    if (found?.joint) {
      const loops = found.joint.loops;
      const next = loops[(loops.indexOf(this.store.loop) + 1) % loops.length];
      this.node = null;
      this.store.selectLoop(next);
      this.store.quiet = false;
      this.showLoop();
      return;
    }
    this.node = found ? found.node : null;
    if (found) this.showNode(found.node);
    else this.bubble.hidden = true;
    this.redraw();
  }

  // Brings the loop's ends into sight.
  showLoop() {
    const joint = this.jointOf(this.store.loop);
    this.redraw();
    if (!joint || this.store.quiet) return;
    this.node = null;
    const at = this.at;
    const x = this.zoom.toX(at[2 * joint.to]);
    const y = this.zoom.toY(at[2 * joint.to + 1]);
    if (x < 0 || y < 0 || x > this.canvas.clientWidth || y > this.canvas.clientHeight) {
      this.zoom.centre(at[2 * joint.to], at[2 * joint.to + 1]);
    }
    const loop = this.store.loopAt(this.store.loop);
    const same = joint.loops.length > 1 ? ` One of ${joint.loops.length} along this line.` : "";
    this.say(
      `Image ${loop.image} is at image ${loop.place}`,
      el("p", {}, `Similarity ${score(loop.score)}, threshold ${score(this.store.data.threshold)}.${same}`),
      this.thumbs([loop.image, loop.place]),
      el("div", {class: "links"}, this.link("See what matched", "loops")),
    );
  }

  showNode(node) {
    const {graph, loops, history} = this.store.data;
    const image = graph.images[node];
    const here = [];
    for (let k = 0; k < loops.image.length; ++k) if (history.node[loops.image[k]] === node) here.push(k);
    const views = graph.views ? `${count(graph.views[node], "image")}; ` : "";
    this.say(
      `Place ${node}`,
      el("p", {class: "name"}, `${views}first seen in image ${image}: ${this.store.file(image)}`),
      this.thumbs([image]),
      el("p", {}, here.length ? `Recognised ${number(here.length)} times:` : "Not seen again."),
      el("div", {class: "links"},
        here.slice(0, loops_listed).map((k) =>
          button(`image ${loops.image[k]}`, () => this.store.selectLoop(k), {title: score(loops.score[k])}))),
      here.length > loops_listed ? el("p", {}, `and ${here.length - loops_listed} more`) : null,
    );
  }

  say(title, ...children) {
    const close = el("button", {class: "close", type: "button", "aria-label": "Close", onclick: () => {
      this.bubble.hidden = true;
      this.node = null;
      this.redraw();
    }}, "✕");
    this.bubble.replaceChildren(el("h3", {}, title, close), ...children.filter(Boolean));
    this.bubble.hidden = false;
  }

  thumbs(images) {
    const shown = images.filter((i) => this.store.picture(i));
    if (shown.length === 0) return null;
    return el("div", {class: shown.length > 1 ? "thumbs" : "thumbs one"},
      shown.map((i) => image(this.store.picture(i).photo, `Image ${i}`)));
  }

  link(text, id) {
    return button(text, () => {
      const target = document.getElementById(id);
      target.scrollIntoView();
      target.focus({preventScroll: true});
    });
  }
}
