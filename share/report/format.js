// Numbers and counts in words.

export function number(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (Number.isInteger(value) && Math.abs(value) < 1e15) return value.toLocaleString("en-GB");
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-3)) return value.toExponential(digits - 1);
  const places = Math.max(0, digits - 1 - Math.max(0, Math.floor(Math.log10(size || 1))));
  return value.toLocaleString("en-GB", {minimumFractionDigits: 0, maximumFractionDigits: places});
}

// Every score with the same number of places, so that they can be compared.
export function score(value) {
  if (value === null || value === undefined) return "–";
  const size = Math.abs(value);
  return size >= 1000 ? value.toExponential(2) : value.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : 2);
}

export function percent(part) {
  return part === null || part === undefined ? "–" : (100 * part).toFixed(part === 1 || part === 0 ? 0 : 1);
}

export function count(n, one, many = `${one}s`) {
  return `${number(n)} ${n === 1 ? one : many}`;
}

// 1, 2 or 5 times a power of ten, so that about `wanted` steps make up the span.
export function niceStep(span, wanted) {
  const raw = span / Math.max(1, wanted);
  const power = 10 ** Math.floor(Math.log10(raw || 1));
  for (const times of [1, 2, 5]) if (times * power >= raw) return times * power;
  return 10 * power;
}
