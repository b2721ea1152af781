// Moving about a drawing: wheel, drag, two fingers, keys. Drawings give the bounds of what there is to see, in their
// own units, y upwards.

const key_step = 60; // pixels

export class Zoom {
  // `bounds()`: {x0, y0, x1, y1}. `changed()` is called after each move, `tapped(x, y)` with canvas pixels.
  constructor(canvas, {bounds, changed, tapped}) {
    Object.assign(this, {canvas, bounds, changed, tapped, scale: 1, x: 0, y: 0, touched: false});
    this.pointers = new Map();
    canvas.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => this.up(event));
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  // To canvas pixels and back.
  toX(x) {
    return this.canvas.clientWidth / 2 + (x - this.x) * this.scale;
  }
  toY(y) {
    return this.canvas.clientHeight / 2 - (y - this.y) * this.scale;
  }
  fromX(x) {
    return this.x + (x - this.canvas.clientWidth / 2) / this.scale;
  }
  fromY(y) {
    return this.y - (y - this.canvas.clientHeight / 2) / this.scale;
  }

  fitScale() {
    const {x0, y0, x1, y1} = this.bounds();
    const room = 40;
    const width = Math.max(40, this.canvas.clientWidth - 2 * room);
    const height = Math.max(40, this.canvas.clientHeight - 2 * room);
    return Math.min(width / Math.max(x1 - x0, 1e-9), height / Math.max(y1 - y0, 1e-9));
  }

  fit() {
    const {x0, y0, x1, y1} = this.bounds();
    this.scale = Math.min(this.fitScale(), 1e9);
    this.x = (x0 + x1) / 2;
    this.y = (y0 + y1) / 2;
    this.touched = false;
    this.changed();
  }

  // By a factor, with the point at canvas pixels (px, py) staying where it is.
  by(factor, px = this.canvas.clientWidth / 2, py = this.canvas.clientHeight / 2) {
    const fit = this.fitScale();
    const scale = Math.min(Math.max(this.scale * factor, fit / 4), fit * 4000);
    const x = this.fromX(px);
    const y = this.fromY(py);
    this.scale = scale;
    this.x += x - this.fromX(px);
    this.y += y - this.fromY(py);
    this.touched = true;
    this.changed();
  }

  shift(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
    this.touched = true;
    this.changed();
  }

  centre(x, y) {
    this.x = x;
    this.y = y;
    this.touched = true;
    this.changed();
  }

  // The page scrolls by the wheel too: the drawing takes it only once it has the focus, or with Ctrl.
  wheel(event) {
    if (document.activeElement !== this.canvas && !event.ctrlKey) return;
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 18 : 1;
    this.by(Math.exp(-event.deltaY * lines * 0.0016), event.offsetX, event.offsetY);
  }

  down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, {x: event.offsetX, y: event.offsetY});
    this.moved = this.pointers.size > 1;
  }

  move(event) {
    const last = this.pointers.get(event.pointerId);
    if (!last) return;
    const now = {x: event.offsetX, y: event.offsetY};
    if (this.pointers.size === 2) {
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)[1];
      const spread = (p) => Math.hypot(p.x - other.x, p.y - other.y);
      this.by(spread(now) / Math.max(1, spread(last)), other.x, other.y);
    } else if (this.moved || Math.hypot(now.x - last.x, now.y - last.y) > 4) {
      this.moved = true;
      this.canvas.classList.add("moving");
      this.shift(now.x - last.x, now.y - last.y);
    } else {
      return;
    }
    this.pointers.set(event.pointerId, now);
  }

  up(event) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.pointers.size > 0) return;
    this.canvas.classList.remove("moving");
    if (!this.moved && event.type === "pointerup") this.tapped(event.offsetX, event.offsetY);
  }

  key(event) {
    const moves = {
      ArrowLeft: [key_step, 0],
      ArrowRight: [-key_step, 0],
      ArrowUp: [0, key_step],
      ArrowDown: [0, -key_step],
    };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key in moves) this.shift(...moves[event.key]);
    else if (event.key === "+" || event.key === "=") this.by(1.5);
    else if (event.key === "-") this.by(1 / 1.5);
    else if (event.key === "0") this.fit();
    else return;
    event.preventDefault();
  }
}
