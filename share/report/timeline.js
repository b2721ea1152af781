// Section "Similarity over time": of each image the best candidate's similarity, and the threshold.
import {css} from "./colours.js";
import {context, el, redrawn, section} from "./dom.js";
import {niceStep, number, score} from "./format.js";

const margin = {left: 46, right: 12, top: 12, bottom: 30};

export class Timeline {
  constructor(store) {
    this.store = store;
    this.canvas = el("canvas", {role: "img", onclick: (event) => this.click(event)});
    this.redraw = redrawn(this.canvas, () => this.draw());
    section(
      "timeline",
      "Similarity over time",
      "Each image's best candidate. Filled dots are loops; the line is the threshold. Click a dot to see its loop.",
      el("div", {class: "card panel"}, this.canvas),
    );
    this.refresh();
    store.on("data", () => this.refresh());
    store.on("loop", () => this.redraw());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.redraw());
  }

  refresh() {
    const {history, threshold, loops} = this.store.data;
    this.loopOf = new Map(loops.image.map((image, k) => [image, k]));
    const scores = history.score.filter((s) => s !== null).sort((a, b) => a - b);
    const high = scores.length ? scores[Math.floor(0.995 * (scores.length - 1))] : threshold;
    this.high = Math.max(1.25 * threshold, 1.05 * high, 1e-6);
    this.low = Math.min(0, scores.length ? scores[Math.floor(0.005 * (scores.length - 1))] : 0);
    this.canvas.setAttribute("aria-label",
      `Best similarity of ${number(history.score.length)} images against the threshold ${score(threshold)}; ` +
      `${number(this.loopOf.size)} are above it and were taken for loops`);
    this.redraw();
  }

  scales(width, height) {
    const images = Math.max(1, this.store.data.history.score.length - 1);
    const x = (image) => margin.left + (image / images) * (width - margin.left - margin.right);
    const y = (value) => {
      const part = (Math.min(value, this.high) - this.low) / (this.high - this.low);
      return height - margin.bottom - Math.max(0, part) * (height - margin.top - margin.bottom);
    };
    return {x, y, images};
  }

  draw() {
    const {c, width, height} = context(this.canvas);
    const {x, y, images} = this.scales(width, height);
    c.clearRect(0, 0, width, height);
    this.axes(c, x, y, width, height, images);
    const {history, loops, threshold} = this.store.data;
    const radius = images > 3000 ? 1.5 : images > 400 ? 2.2 : 3.4;
    c.fillStyle = css("--muted");
    c.globalAlpha = 0.5;
    history.score.forEach((value, image) => {
      if (value !== null && !this.loopOf.has(image)) this.dot(c, x(image), y(value), radius);
    });
    c.globalAlpha = 1;
    for (const [image, k] of this.loopOf) {
      c.fillStyle = css(loops.right[k] === false ? "--wrong" : "--accent");
      this.dot(c, x(image), y(loops.score[k]), radius);
    }
    c.strokeStyle = css("--ink");
    c.lineWidth = 1.2;
    c.setLineDash([5, 4]);
    c.beginPath();
    c.moveTo(margin.left, y(threshold));
    c.lineTo(width - margin.right, y(threshold));
    c.stroke();
    c.setLineDash([]);
    if (this.store.loop !== null) {
      c.beginPath();
      c.arc(x(loops.image[this.store.loop]), y(loops.score[this.store.loop]), radius + 4, 0, 7);
      c.lineWidth = 2;
      c.stroke();
    }
  }

  dot(c, x, y, radius) {
    if (radius < 2) {
      c.fillRect(x - radius, y - radius, 2 * radius, 2 * radius);
      return;
    }
    c.beginPath();
    c.arc(x, y, radius, 0, 7);
    c.fill();
  }

  axes(c, x, y, width, height, images) {
    c.font = "12px system-ui, sans-serif";
    c.fillStyle = css("--muted");
    c.strokeStyle = css("--rule");
    c.lineWidth = 1;
    c.textAlign = "right";
    c.textBaseline = "middle";
    const step = niceStep(this.high - this.low, 4);
    for (let v = Math.ceil(this.low / step) * step; v <= this.high; v += step) {
      c.beginPath();
      c.moveTo(margin.left, y(v));
      c.lineTo(width - margin.right, y(v));
      c.stroke();
      c.fillText(number(Number(v.toPrecision(6))), margin.left - 8, y(v));
    }
    c.textBaseline = "top";
    const along = Math.max(1, niceStep(images, width / 90));
    for (let i = 0; i <= images; i += along) {
      c.textAlign = i === 0 ? "left" : x(i) > width - 40 ? "right" : "center";
      c.fillText(i === 0 ? "image 0" : number(i), x(i), height - margin.bottom + 9);
    }
  }

  click(event) {
    const {x, y} = this.scales(this.canvas.clientWidth, this.canvas.clientHeight);
    let nearest = 18;
    let chosen = null;
    for (const [image, k] of this.loopOf) {
      const distance = Math.hypot(x(image) - event.offsetX, y(this.store.data.loops.score[k]) - event.offsetY);
      if (distance < nearest) {
        nearest = distance;
        chosen = k;
      }
    }
    if (chosen !== null) this.store.selectLoop(chosen);
  }
}
