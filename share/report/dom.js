// Elements are made by these functions alone; text is set as text and never as markup.

// el("p", {class: "note"}, "text", child, ...): properties that begin with "on" are listeners.
export function el(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

export function svg(tag, attributes = {}, ...children) {
  return fill(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

function fill(element, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else element.setAttribute(key, value === true ? "" : String(value));
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

// Fills a section of the page and shows it.
export function section(id, title, note, ...children) {
  const element = document.getElementById(id);
  const head = el("div", {class: "head"}, el("h2", {id: `${id}-title`}, title));
  if (note) head.append(el("p", {class: "note"}, note));
  element.replaceChildren(head, ...children.flat().filter(Boolean));
  element.hidden = false;
  return element;
}

export function button(text, action, attributes = {}) {
  return el("button", {class: "button", type: "button", onclick: action, ...attributes}, text);
}

// A data URI of a picture, or nothing: whatever else a data file might hold is not loaded.
export function image(uri, alt) {
  const source = /^data:image\/jpeg;base64,[A-Za-z0-9+/=]*$/.test(uri) ? uri : "data:,";
  return el("img", {src: source, alt, decoding: "async"});
}

// The canvas made as large as it is shown, and its context in CSS pixels.
export function context(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const c = canvas.getContext("2d");
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  return {c, width, height};
}

// Calls `draw` at the next frame, however often it is asked to, and when the size changes.
export function redrawn(canvas, draw) {
  let asked = false;
  const ask = () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      if (canvas.clientWidth > 0) draw();
    });
  };
  new ResizeObserver(ask).observe(canvas);
  return ask;
}
