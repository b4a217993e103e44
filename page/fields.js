// Values and colours: which number each corner has, where a colour map has it, and the ticks of a legend.

const noValue = 1e38;  // for the shader: infinite, or not a number

/// Where finite values lie.
function rangeOf(numbers) {
  let low = Infinity, high = -Infinity;
  for (const x of numbers) if (Number.isFinite(x)) { if (x < low) low = x; if (x > high) high = x; }
  return low <= high ? [low, high] : [0, 1];
}

/// From a value to a number in [0, 1] over a range, without overflow.
const fraction = (x, [low, high]) => (high > low ? (x / 2 - low / 2) / (high / 2 - low / 2) : 0.5);

/// The place of a value in the colour map, by the knots [value, place] of a scale.
function placeOf(scale, x) {
  let i = 1;
  while (i + 1 < scale.length && x >= scale[i][0]) ++i;
  const [a, b] = [scale[i - 1], scale[i]];
  return a[1] + Math.min(1, Math.max(0, fraction(x, [a[0], b[0]]))) * (b[1] - a[1]);
}

const componentsOf = (field) => (field.width === 1 ? ["value"] : ["length", ...["x", "y", "z", "w"].slice(0, Math.min(field.width, 4))]);

/// One number for each element of a field: itself, a component or the length.
function componentNumbers(field, component) {
  if (field.width === 1) return field.numbers;
  const n = field.numbers.length / field.width, result = new Float64Array(n), k = componentsOf(field).indexOf(component) - 1;
  for (let i = 0; i < n; ++i) {
    const v = field.numbers.subarray(field.width * i, field.width * (i + 1));
    result[i] = k < 0 ? Math.hypot(...v) : v[k];
  }
  return result;
}

const labelOf = (x) => (x >= 0 && x < 2 ** 53 && Number.isInteger(x) ? x : NaN);

/// By corner of the triangles of a list: the number of a field for the shader. `by`: as the list names its elements.
function cornerNumbers(list, at, numbers, range, labels) {
  const result = new Float32Array(list.triangles.length);
  const shaderNumber = labels ? (x) => (Number.isNaN(labelOf(x)) ? noValue : labelOf(x) % 20)
    : (x) => (Number.isFinite(x) ? Math.max(-1e29, Math.min(1e29, fraction(x, range))) : noValue);
  const perPolygon = at === "poly" ? list.polys : at === "face" ? list.elements : null, atCorners = at === "corner" && list.mesh;
  const placeOf = (vert, p) => (atCorners ? list.mesh.cornerAt(list.polys[p], vert) : vert);
  for (let i = 0; i < result.length; ++i) {
    const c = list.triangles[i], p = list.polygonOf[Math.floor(i / 3)];
    let x = NaN;
    if (at === "polygon") x = numbers[p];
    else if (at === "corner" && !atCorners) x = numbers[c];
    else if (perPolygon) x = numbers[perPolygon[p]];
    else if ((at === "vert" || atCorners) && list.between) {
      const [v, w, t] = list.between[list.corners[c]], a = numbers[placeOf(v, p)], b = numbers[placeOf(w, p)];
      x = t === 0 ? a : t === 1 ? b : a * (1 - t) + b * t;
    } else if (at === "vert" || at === "point" || atCorners) x = numbers[placeOf(list.corners[c], p)];
    result[i] = shaderNumber(x);
  }
  return result;
}

/// By corner of the triangles: the numbers of the three sides of its triangle, of a field at edges.
function sideNumbers(list, numberOfSide, range) {
  const result = new Float32Array(3 * list.triangles.length);
  for (let t = 0; t < list.triangles.length / 3; ++t)
    for (let k = 0; k < 3; ++k) {
      const c = list.triangles[3 * t + k], d = list.triangles[3 * t + (k + 1) % 3], x = numberOfSide(c, d);
      const number = Number.isFinite(x) ? fraction(x, range) : noValue;
      for (let j = 0; j < 3; ++j) result[9 * t + 3 * j + k] = number;
    }
  return result;
}

const exponentOf = (x) => (x === 0 ? 0 : Math.floor(Math.log10(Math.abs(x)) + 1e-9));
function roundStep(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return ([1, 2, 5].find((m) => x <= m * power * (1 + 1e-9)) ?? 10) * power;
}
function multiples(low, high, step) {
  const values = [], first = Math.ceil(low / step - 1e-6), last = Math.floor(high / step + 1e-6);
  if (last - first < 1000) for (let k = first; k <= last; ++k) values.push(Math.min(Math.max(k * step, low), high));
  return values;
}
function tickText(x, step) {
  const digits = Math.max(0, -exponentOf(step)), plain = x.toFixed(Math.min(digits, 100));
  if (plain.length <= 7) return plain.replace("-", "−");
  return x.toExponential(Math.max(0, Math.min(20, exponentOf(x) - exponentOf(step)))).replace(/\.?0*e/, "e").replace(/e([+-])(\d+)/, (_, sign, n) =>
    `·10${sign === "-" ? "⁻" : ""}${[...n].map((d) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]).join("")}`).replace("-", "−");
}
/// Round numbers in a range, about `count` of them: [value, text].
function roundTicks(low, high, count) {
  const part = high / count - low / count, size = Math.max(Math.abs(low), Math.abs(high));
  if (!(part > size * 1e-12) || part < 1e-300) return [[low / 2 + high / 2, textOf(Number((low / 2 + high / 2).toPrecision(6)))]];
  const step = roundStep(part), finer = roundStep(0.4 * step), few = multiples(low, high, step), many = multiples(low, high, finer);
  const takesFew = few.length >= 2 && Math.abs(few.length - count) <= Math.abs(many.length - count);
  return (takesFew ? few : many).map((x) => [x, tickText(x, takesFew ? step : finer)]);
}
/// Ticks of a scale: at about equal distances in the colour map.
function scaleTicks(scale, count) {
  const low = scale[0][0], high = scale[scale.length - 1][0];
  if (scale.length === 2 || !(high > low)) return roundTicks(low, high, count);
  const valueAt = (place) => {
    let a = 0, b = 1;
    for (let k = 0; k < 60; ++k) { const m = (a + b) / 2; if (placeOf(scale, low * (1 - m) + high * m) < place) a = m; else b = m; }
    return low * (1 - a) + high * a;
  };
  const ticks = [];
  for (let k = 0; k <= count; ++k) {
    const a = valueAt(Math.max(0, (k - 0.2) / count)), b = valueAt(Math.min(1, (k + 0.2) / count));
    if (!(b - a > 1e-12 * Math.max(Math.abs(a), Math.abs(b)))) continue;
    const power = 10 ** exponentOf(b - a);
    for (const m of [10, 5, 2, 1]) {
      const inside = multiples(a, b, m * power);
      if (!inside.length) continue;
      const x = inside[Math.floor(inside.length / 2)];
      ticks.push([x, tickText(x, m * power)]);
      break;
    }
  }
  return ticks;
}
