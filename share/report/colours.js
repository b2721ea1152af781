// The scale of scores: viridis (Smith and van der Walt), which the colour-blind read too, at 17 points.
const viridis_points = [
  [68, 1, 84], [72, 24, 106], [71, 45, 123], [66, 64, 134], [59, 82, 139], [51, 99, 141], [44, 114, 142],
  [38, 130, 142], [33, 145, 140], [31, 160, 136], [40, 174, 128], [63, 188, 115], [94, 201, 98],
  [132, 212, 75], [173, 220, 48], [216, 226, 25], [253, 231, 37],
];

// [red, green, blue] at a part 0 .. 1.
export function viridis(part) {
  const at = Math.min(1, Math.max(0, part)) * (viridis_points.length - 1);
  const k = Math.min(viridis_points.length - 2, Math.floor(at));
  return viridis_points[k].map((from, c) => Math.round(from + (at - k) * (viridis_points[k + 1][c] - from)));
}

// Scores from `low` (the threshold) to `high`. Its dark end is left out: it would be lost on the dark ground.
export class ScoreScale {
  constructor(low, high) {
    this.low = low;
    this.high = high > low ? high : low + 1;
  }
  part(value) {
    return Math.min(1, Math.max(0, (value - this.low) / (this.high - this.low)));
  }
  colour(value) {
    return `rgb(${viridis(0.28 + 0.72 * this.part(value)).join(" ")})`;
  }
}

// Colours far apart, for what is told apart by hue alone.
export function distinct(k) {
  return `hsl(${(20 + k * 137.508) % 360} 90% 62%)`;
}

export function drawScale(canvas) {
  canvas.width = 120;
  canvas.height = 10;
  const c = canvas.getContext("2d");
  for (let x = 0; x < 120; ++x) {
    c.fillStyle = `rgb(${viridis(0.28 + (0.72 * x) / 119).join(" ")})`;
    c.fillRect(x, 0, 1, 10);
  }
}

export function css(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
