// Section "Details": timings and parameters.
import {el, section} from "./dom.js";
import {number} from "./format.js";

function table(caption, rows) {
  return el("div", {class: "card panel"}, el("h3", {}, caption), el("table", {}, el("tbody", {},
    rows.map(([name, value]) =>
      el("tr", {}, el("th", {scope: "row"}, name), el("td", {class: "number"}, value))))));
}

// {"match": {"method": "paper"}} as [["match · method", "paper"]].
function flattened(object, path = []) {
  return Object.entries(object ?? {}).flatMap(([key, value]) =>
    value !== null && typeof value === "object"
      ? flattened(value, [...path, key])
      : [[[...path, key].join(" · ").replaceAll("_", " "), typeof value === "number" ? number(value, 6) : String(value)]]);
}

export function showDetails(store) {
  const {data} = store;
  const timings = (data.timings ?? []).map(({what, value, unit}) => [what, `${number(value)} ${unit}`]);
  const front = data.frontend ? [["front end", data.frontend]] : [];
  const about = [["method", data.method], ...front, ...flattened(data.parameters)];
  section("details", "Timings and parameters", null,
    el("div", {class: "two"},
      timings.length ? table("Timings, of the machine that made this page", timings) : null,
      table("Parameters", about)));
}
