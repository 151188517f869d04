// SPDX-License-Identifier: MIT
// Where a value stands on its slider, and how many digits it deserves. No page here.
const NO_BOUND = 1e29;   // the format's default bounds are +-1e30
const PLACES = 200;      // of a slider without a step of its own
const DECADES = 1e-3;    // of its end: where the logarithmic part of a slider from 0 begins
const ZERO_ZONE = 0.02;  // share of such a slider that is 0
const LENGTH_SHARE = 0.2;  // of the scene's diagonal: the end of a length's slider in a scene of another size

const isLength = param => param.semantic === "length" || param.unit === "scene units";

/// The param's soft range. A length that does not fit the scene at all ends at a share of the scene.
function softRange(param, diagonal = 0) {
  const most = Math.max(...param.initial.map(Math.abs), 0);
  let low = param.min <= -NO_BOUND ? (Math.min(...param.initial) < 0 ? -4 * most : 0) : param.min;
  let high = param.soft_max || (param.max >= NO_BOUND ? 4 * most || 1 : param.max);
  if (param.semantic === "length" && diagonal > 0 && (high < 0.02 * diagonal || high > 2 * diagonal))
    high = Math.min(param.max, round(LENGTH_SHARE * diagonal, 2));
  if (!(high > low)) high = Math.min(param.max, low + 1);
  return {low, high};
}

/// {places, place(value), value(place)}; a place is a whole number of [0, places].
export function scaleOf(param, diagonal = 0) {
  const {low, high} = softRange(param, diagonal), int = param.type === "int";
  const log = low > 0 ? high / low > 100 : low === 0 && isLength(param) && !int;
  return log ? logScale(param, low, high) : linearScale(param, low, high);
}

function linearScale(param, low, high) {
  const int = param.type === "int", step = param.step || (int ? 1 : 0);
  const counted = step > 0 ? Math.round((high - low) / step) : 0;
  const places = counted > 0 && counted <= 1000 ? counted : PLACES;
  return {
    places,
    place: value => Math.round(places * (value - low) / (high - low)),
    value: place => place >= places ? high : snapped(param, low + (high - low) * place / places)
  };
}

function logScale(param, low, high) {
  const begin = low > 0 ? low : DECADES * high, zone = low > 0 ? 0 : ZERO_ZONE;
  const share = value => value < begin * 0.999 && low <= 0
    ? 0 : zone + (1 - zone) * Math.log(Math.max(value, begin) / begin) / Math.log(high / begin);
  const value = place => {
    const t = (place / PLACES - zone) / (1 - zone);
    if (place <= 0 || t < 0) return low;
    return place >= PLACES ? high : snapped(param, begin * (high / begin) ** t);
  };
  return {places: PLACES, place: v => Math.round(PLACES * share(v)), value};
}

// On the step or the whole number, else to three digits.
function snapped(param, value) {
  if (param.type === "int") return Math.round(value);
  if (param.step > 0) return round(Math.round(value / param.step) * param.step, 6);
  return round(value, 3);
}

export function round(value, digits) {
  return Number(Number(value).toPrecision(digits));
}

/// Inside of the hard range, whole where the param is.
export function clamped(param, value) {
  const inside = Math.min(param.max, Math.max(param.min, value));
  return param.type === "int" ? Math.round(inside) : inside;
}

/// A value as people read it: floats of the engine are single precision.
export const shown = value => String(round(value, 6));

export const same = (a, b) => a.length === b.length &&
  a.every((x, i) => Math.abs(x - b[i]) <= 1e-6 * Math.max(1e-6, Math.abs(x), Math.abs(b[i])));
