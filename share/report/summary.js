// The head of the page: what this is, the verdict in figures, what went wrong, and the way to the sections.
import {el} from "./dom.js";
import {count, number, percent, score} from "./format.js";

const doubtful_margin = 0.1; // of the score

function lead(data) {
  const b = (text) => el("b", {}, text);
  const loops = data.loops.image.length;
  if (data.kind === "evaluation") {
    const e = data.evaluation;
    return ["Of ", b(count(e.queries_with_match, "image")), " taken at a place seen before, ",
      b(`${percent(e.fixed.recall)} %`), " were recognised; ", b(`${percent(e.fixed.precision)} %`),
      ` of ${count(e.fixed.detections, "detection")} were right.`];
  }
  const images = b(count(data.images.count, "image"));
  const found = loops === 0 ? b("never") : b(loops === 1 ? "once" : `${number(loops)} times`);
  return [images, ` became a map of `, b(count(data.graph.nodes, "place")), "; the camera was found back at one of them ",
    found, "."];
}

function figures(data) {
  const {loops} = data;
  const doubtful = loops.margin.filter((margin) => margin < doubtful_margin).length;
  const list = [["Images", number(data.images.count)]];
  if (data.graph) list.push(["Places", number(data.graph.nodes)]);
  list.push(["Loops", number(loops.image.length), "chief"]);
  if (data.evaluation) {
    list.push(["Precision", percent(data.evaluation.fixed.precision), "chief", "%"],
      ["Recall", percent(data.evaluation.fixed.recall), "chief", "%"]);
    if (data.kind === "evaluation") list.push(["Average precision", number(data.evaluation.average_precision)]);
  }
  list.push(["Doubtful loops", number(doubtful), "", "", "Nearer than a tenth to the threshold or the runner-up"],
    ["Threshold", score(data.threshold)]);
  return el("dl", {class: "figures"}, list.map(([name, value, kind, unit, title]) =>
    el("div", {class: kind || null, title: title || null}, el("dt", {}, name),
      el("dd", {}, value, unit ? el("small", {}, ` ${unit}`) : null))));
}

function notices(problems) {
  if (!problems || problems.length === 0) return null;
  if (problems.length === 1) return el("p", {class: "notice"}, problems[0]);
  return el("details", {class: "notice"}, el("summary", {}, problems[0]),
    el("ul", {}, problems.slice(1).map((problem) => el("li", {}, problem))));
}

export function showSummary(store, ...more) {
  const {data} = store;
  const kind = {map: "Map report", evaluation: "Evaluation report", live: "Live view"}[data.kind];
  document.getElementById("summary").replaceChildren(
    el("p", {class: "over"}, `sailmap · ${kind}`),
    el("h1", {class: "name"}, data.title),
    el("p", {class: "lead"}, lead(data)),
    figures(data),
    ...[notices(data.problems), ...more].filter(Boolean));
}

export function showSections() {
  const links = [...document.querySelectorAll("main > section:not([hidden])")].map((section) =>
    el("li", {}, el("a", {href: `#${section.id}`}, section.querySelector("h2").textContent)));
  document.getElementById("sections").replaceChildren(el("ul", {}, links));
}

export function showFoot(data) {
  const method = data.method ? `, method ${data.method}` : "";
  document.getElementById("foot").replaceChildren(
    el("p", {}, data.kind === "live" ? "Served by sailmap run --view. " : `Made ${data.made} by sailmap${method}. `,
      "Scores are coloured by the viridis scale. ",
      data.kind === "live" ? "" : "This page needs no network."));
}
