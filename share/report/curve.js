// Section "Precision and recall".
import {el, section, svg} from "./dom.js";
import {number, percent, score} from "./format.js";

const size = {width: 560, height: 410, left: 62, bottom: 54, top: 14, right: 16};
const toX = (recall) => size.left + recall * (size.width - size.left - size.right);
const toY = (precision) => size.height - size.bottom - precision * (size.height - size.top - size.bottom);

function gridLines() {
  const lines = [];
  for (const part of [0, 0.2, 0.4, 0.6, 0.8, 1]) {
    lines.push(
      svg("line", {class: "grid", x1: toX(part), x2: toX(part), y1: toY(0), y2: toY(1)}),
      svg("line", {class: "grid", x1: toX(0), x2: toX(1), y1: toY(part), y2: toY(part)}),
      svg("text", {x: toX(part), y: toY(0) + 20, "text-anchor": "middle"}, `${Math.round(100 * part)}`),
      svg("text", {x: toX(0) - 8, y: toY(part) + 4, "text-anchor": "end"}, `${Math.round(100 * part)}`));
  }
  const middle = (toY(0) + toY(1)) / 2;
  return [...lines,
    svg("text", {x: (toX(0) + toX(1)) / 2, y: size.height - 6, "text-anchor": "middle"}, "recall, %"),
    svg("text", {x: 12, y: middle, "text-anchor": "middle", transform: `rotate(-90 12 ${middle})`}, "precision, %")];
}

export class CurveView {
  constructor(store) {
    this.evaluation = store.data.evaluation;
    this.points = [];
    const {curve} = this.evaluation;
    for (let i = 0; i < curve.length; i += 3) {
      this.points.push({threshold: curve[i], precision: curve[i + 1], recall: curve[i + 2]});
    }
    this.at = null;
    this.readout = el("p", {class: "readout", "aria-live": "polite"},
      "Point at the curve, or focus it and use the arrow keys, to see what another threshold gives.");
    section("precision", "Precision and recall",
      "How many of the loops are right, and how many of the revisits were found, as the threshold falls.",
      el("div", {class: "two"},
        el("div", {class: "card panel"}, this.chart(), this.readout),
        el("div", {class: "card panel"}, this.table())));
  }

  chart() {
    const {fixed} = this.evaluation;
    const steps = this.points.map((p) => `${toX(p.recall)},${toY(p.precision)}`);
    const first = this.points[0];
    const last = this.points[this.points.length - 1];
    const area = first
      ? [`${toX(0)},${toY(0)}`, `${toX(0)},${toY(first.precision)}`, ...steps, `${toX(last.recall)},${toY(0)}`]
      : [];
    this.probe = svg("circle", {class: "probe", r: 5, cx: -99, cy: -99});
    const chart = svg("svg", {
      class: "chart",
      viewBox: `0 0 ${size.width} ${size.height}`,
      role: "img",
      tabindex: "0",
      "aria-label": `Precision-recall curve, average precision ${number(this.evaluation.average_precision)}`,
    },
    gridLines(),
    svg("polygon", {class: "area", points: area.join(" ")}),
    svg("polyline", {class: "line", points: steps.join(" ")}),
    svg("circle", {class: "at", r: 6, cx: toX(fixed.recall), cy: toY(fixed.precision)}),
    this.probe);
    chart.addEventListener("pointermove", (event) => {
      const box = chart.getBoundingClientRect();
      this.show(this.nearest(((event.clientX - box.left) / box.width) * size.width,
        ((event.clientY - box.top) / box.height) * size.height));
    });
    chart.addEventListener("keydown", (event) => {
      const by = {ArrowRight: 1, ArrowLeft: -1, ArrowDown: 1, ArrowUp: -1}[event.key];
      if (by === undefined) return;
      event.preventDefault();
      this.show(Math.min(this.points.length - 1, Math.max(0, (this.at ?? -1) + by)));
    });
    return chart;
  }

  nearest(x, y) {
    let best = null;
    let nearest = Infinity;
    this.points.forEach((p, k) => {
      const distance = Math.hypot(toX(p.recall) - x, toY(p.precision) - y);
      if (distance < nearest) [nearest, best] = [distance, k];
    });
    return best;
  }

  show(k) {
    if (k === null || !this.points[k]) return;
    this.at = k;
    const point = this.points[k];
    this.probe.setAttribute("cx", toX(point.recall));
    this.probe.setAttribute("cy", toY(point.precision));
    this.readout.textContent = `Threshold ${score(point.threshold)}: precision ${percent(point.precision)} %, ` +
      `recall ${percent(point.recall)} %.`;
  }

  table() {
    const e = this.evaluation;
    const row = (name, value) => el("tr", {}, el("th", {scope: "row"}, name), el("td", {class: "number"}, value));
    return el("table", {},
      el("tbody", {},
        row(`Precision at threshold ${score(e.fixed.threshold)}`, `${percent(e.fixed.precision)} %`),
        row(`Recall at threshold ${score(e.fixed.threshold)}`, `${percent(e.fixed.recall)} %`),
        row("Detections, of them right", `${number(e.fixed.detections)}, ${number(e.fixed.right)}`),
        row("Images that could be compared", number(e.queries)),
        row("of them at a place seen before", number(e.queries_with_match)),
        row("Average precision", number(e.average_precision)),
        row("Recall at 100 % precision", `${percent(e.recall_at_100)} %`),
        row("Recall at 95 % precision", `${percent(e.recall_at_95)} %`),
        row("Best F1", `${number(e.best_f1)} at ${score(e.best_f1_threshold)}`)));
  }
}
