// Section "Similarity": every image against the places before it, with the loops and the ground truth marked.
import {css, viridis} from "./colours.js";
import {context, el, redrawn, section} from "./dom.js";
import {niceStep, number, score} from "./format.js";

const none = 255; // a cell that was not compared
const frame_size = {left: 52, bottom: 34, top: 10, right: 10};

// The last index whose value is not above `value`; -1 when all are.
export function lastNotAbove(rising, value) {
  let [low, high] = [0, rising.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rising[middle] <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export class MatrixView {
  constructor(store) {
    this.store = store;
    this.matrix = store.data.matrix;
    const bytes = atob(this.matrix.cells);
    this.cells = Uint8Array.from(bytes, (c) => c.charCodeAt(0));
    this.width = this.matrix.columns.length;
    this.height = this.matrix.rows.length;
    this.cursor = null;
    this.marks = {loops: true, truth: true};
    this.canvas = el("canvas", {
      class: "matrix",
      tabindex: "0",
      role: "img",
      "aria-label": `Similarity matrix of ${this.height} rows, images, and ${this.width} columns, known places. ` +
        "Arrow keys move a cursor that is read out.",
      onclick: (event) => this.point(event, true),
      onpointermove: (event) => this.point(event, false),
      onkeydown: (event) => this.key(event),
    });
    this.readout = el("p", {class: "readout", "aria-live": "polite"});
    this.redraw = redrawn(this.canvas, () => this.draw());
    this.picture = this.paint();
    this.build();
    this.say();
    store.on("loop", () => this.redraw());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.redraw());
  }

  build() {
    const scale = el("canvas", {width: 254, height: 12, "aria-hidden": "true"});
    scale.style.width = "100%";
    const c = scale.getContext("2d");
    for (let x = 0; x < 254; ++x) {
      c.fillStyle = `rgb(${viridis(x / 253).join(" ")})`;
      c.fillRect(x, 0, 1, 12);
    }
    section(
      "similarity",
      "Similarity matrix",
      "Each row is an image, each column a place it was compared with. Bright diagonals are ways travelled again.",
      el("div", {class: "two"},
        el("div", {class: "card panel"}, this.canvas),
        el("div", {class: "card panel"},
          el("h3", {}, "Under the cursor"), this.readout,
          el("div", {class: "tools"}, this.toggle("loops", "mark the loops"),
            this.matrix.truth.length > 0 ? this.toggle("truth", "mark the ground truth") : null),
          el("p", {class: "muted"}, el("br"), scale),
          el("p", {class: "note"},
            `Colours go from 0 to ${score(this.matrix.ceiling)}, the 99.5th percentile. ${this.thinned()}`))),
    );
  }

  thinned() {
    const images = this.store.data.images.count;
    const single = "Similarities are those of single images, before any filter over time. ";
    const live = this.store.data.kind === "map" ? single : "";
    if (images <= this.height) return live;
    return `${live}${number(images)} images are shown by ${this.height} rows.`;
  }

  toggle(key, text) {
    return el("label", {class: "field"}, el("input", {type: "checkbox", checked: true, onchange: (event) => {
      this.marks[key] = event.target.checked;
      this.redraw();
    }}), text);
  }

  // The cells as a picture of one pixel each.
  paint() {
    const canvas = el("canvas", {width: this.width, height: this.height});
    const c = canvas.getContext("2d");
    const pixels = c.createImageData(this.width, this.height);
    this.cells.forEach((value, i) => {
      if (value === none) return;
      pixels.data.set([...viridis(value / 254), 255], 4 * i);
    });
    c.putImageData(pixels, 0, 0);
    return canvas;
  }

  area(width, height) {
    return {
      x: frame_size.left,
      y: frame_size.top,
      width: width - frame_size.left - frame_size.right,
      height: height - frame_size.top - frame_size.bottom,
    };
  }

  draw() {
    const {c, width, height} = context(this.canvas);
    const at = this.area(width, height);
    c.clearRect(0, 0, width, height);
    c.fillStyle = css("--paper");
    c.fillRect(at.x, at.y, at.width, at.height);
    c.imageSmoothingEnabled = this.width > at.width * 1.2;
    c.drawImage(this.picture, at.x, at.y, at.width, at.height);
    const cell = {x: at.width / this.width, y: at.height / this.height};
    if (this.marks.truth) this.drawTruth(c, at, cell);
    if (this.marks.loops) this.drawLoops(c, at, cell);
    this.axes(c, at);
    if (this.cursor) {
      const x = at.x + (this.cursor.column + 0.5) * cell.x;
      const y = at.y + (this.cursor.row + 0.5) * cell.y;
      c.strokeStyle = css("--ink");
      c.lineWidth = 1;
      c.strokeRect(x - Math.max(4, cell.x / 2), y - Math.max(4, cell.y / 2), Math.max(8, cell.x), Math.max(8, cell.y));
    }
  }

  drawTruth(c, at, cell) {
    c.fillStyle = "rgb(255 255 255 / 55%)";
    const {truth} = this.matrix;
    const side = Math.max(1.4, Math.min(cell.x, cell.y) * 0.42);
    for (let i = 0; i < truth.length; i += 2) {
      c.fillRect(at.x + (truth[i] + 0.5) * cell.x - side / 2, at.y + (truth[i + 1] + 0.5) * cell.y - side / 2, side, side);
    }
  }

  // Column and row of a loop.
  cellOf(k) {
    const loop = this.store.loopAt(k);
    return {
      column: lastNotAbove(this.matrix.columns, this.store.data.loops.place[k]),
      row: lastNotAbove(this.matrix.rows, loop.image),
    };
  }

  drawLoops(c, at, cell) {
    const {loops} = this.store.data;
    const radius = Math.min(4.5, Math.max(2, Math.min(cell.x, cell.y) * 0.8));
    for (let k = 0; k < loops.image.length; ++k) {
      const {column, row} = this.cellOf(k);
      const chosen = k === this.store.loop;
      c.beginPath();
      c.arc(at.x + (column + 0.5) * cell.x, at.y + (row + 0.5) * cell.y, chosen ? radius + 4 : radius, 0, 7);
      c.strokeStyle = chosen ? css("--ink") : loops.right[k] === false ? "#ff6b5e" : "#ffffff";
      c.lineWidth = chosen ? 2.5 : 1.3;
      c.stroke();
    }
  }

  axes(c, at) {
    c.font = "12px system-ui, sans-serif";
    c.fillStyle = css("--muted");
    // Not nearer to each other than half of what is usual: columns need not be evenly spread.
    const ticks = (starts, along) => {
      const span = starts[starts.length - 1] - starts[0];
      const step = Math.max(1, niceStep(span, along));
      const out = [];
      for (let v = Math.ceil(starts[0] / step) * step; v <= starts[starts.length - 1]; v += step) {
        const part = (lastNotAbove(starts, v) + 0.5) / starts.length;
        if (out.length === 0 || part - out[out.length - 1][1] > 0.5 / along) out.push([v, part]);
      }
      return out;
    };
    c.textAlign = "right";
    c.textBaseline = "middle";
    for (const [v, part] of ticks(this.matrix.rows, 8)) c.fillText(number(v), at.x - 7, at.y + part * at.height);
    c.textAlign = "center";
    c.textBaseline = "top";
    for (const [v, part] of ticks(this.matrix.columns, at.width / 80)) {
      c.fillText(number(v), at.x + part * at.width, at.y + at.height + 7);
    }
    c.textAlign = "left";
    c.fillText("place →", at.x, at.y + at.height + 21);
    c.save();
    c.translate(2, at.y + at.height);
    c.rotate(-Math.PI / 2);
    c.fillText("← image", at.height - 52, 0);
    c.restore();
  }

  point(event, choose) {
    const at = this.area(this.canvas.clientWidth, this.canvas.clientHeight);
    const column = Math.floor(((event.offsetX - at.x) / at.width) * this.width);
    const row = Math.floor(((event.offsetY - at.y) / at.height) * this.height);
    if (column < 0 || row < 0 || column >= this.width || row >= this.height) return;
    this.cursor = {column, row};
    this.say();
    this.redraw();
    if (choose) this.chooseLoop();
  }

  // The loop nearest to the cursor, if there is one within a few cells.
  chooseLoop() {
    let chosen = null;
    let nearest = Math.max(4, this.width / 60);
    for (let k = 0; k < this.store.loopCount; ++k) {
      const {column, row} = this.cellOf(k);
      const distance = Math.hypot(column - this.cursor.column, row - this.cursor.row);
      if (distance < nearest) {
        nearest = distance;
        chosen = k;
      }
    }
    if (chosen !== null) this.store.selectLoop(chosen);
  }

  say() {
    if (!this.cursor) {
      this.readout.textContent = "Point at a cell, or move with the arrow keys. A click chooses the nearest loop.";
      return;
    }
    const {column, row} = this.cursor;
    const value = this.cells[row * this.width + column];
    const where = `${this.store.label(this.matrix.rows[row])} and ${this.store.label(this.matrix.columns[column])}`;
    const what = value === none ? "not compared" : `similarity ${score((value / 254) * this.matrix.ceiling)}`;
    this.readout.textContent = `${where[0].toUpperCase()}${where.slice(1)}: ${what}${value === 254 ? " or more" : ""}.`;
  }

  key(event) {
    const moves = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
    if (event.key === "Enter" && this.cursor) this.chooseLoop();
    if (!(event.key in moves)) return;
    event.preventDefault();
    const by = event.shiftKey ? 10 : 1;
    const from = this.cursor ?? {column: 0, row: Math.floor(this.height / 2)};
    const inside = (v, size) => Math.min(size - 1, Math.max(0, v));
    this.cursor = {
      column: inside(from.column + by * moves[event.key][0], this.width),
      row: inside(from.row + by * moves[event.key][1], this.height),
    };
    this.say();
    this.redraw();
  }
}
