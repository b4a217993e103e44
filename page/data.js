// The scene as the file holds it: one text of JSON, and arrays of numbers in base64.

const byId = (id) => document.getElementById(id);
const scene = JSON.parse(byId("scene").textContent);
const arrays = [...document.querySelectorAll("script[data-type]")];
const arrayTypes = { i1: Int8Array, u1: Uint8Array, u2: Uint16Array, u4: Uint32Array, f4: Float32Array, f8: Float64Array };

/// The numbers of array k; an empty array where there is none.
function numbersOf(k) {
  if (k === undefined || k === null) return new Float32Array(0);
  const { type, length } = arrays[k].dataset, text = arrays[k].textContent.trim();
  const bytes = new Uint8Array(Number(length) * arrayTypes[type].BYTES_PER_ELEMENT);
  const piece = 1 << 20;  // characters, a multiple of 4
  for (let from = 0, to = 0; from < text.length; from += piece) {
    const part = atob(text.slice(from, from + piece));
    for (let i = 0; i < part.length; ++i) bytes[to++] = part.charCodeAt(i);
  }
  arrays[k].textContent = "";
  return new arrayTypes[type](bytes.buffer);
}

/// Replaces the numbers of arrays by the arrays: { points: 3 } becomes { points: Float32Array }.
function readArrays(named) {
  const result = {};
  for (const [name, k] of Object.entries(named)) result[name] = numbersOf(k);
  return result;
}

/// The shortest text of a number with at most nine digits; says so if it is none.
function textOf(x) {
  if (typeof x === "string") return x;
  if (Number.isNaN(x)) return "not a number";
  if (x === Infinity) return "infinite";
  if (x === -Infinity) return "minus infinite";
  return String(Number(x.toPrecision(9)));
}

/// An element of the page. Texts are set as text, never as HTML.
function make(tag, attributes = {}, ...content) {
  const e = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) e.addEventListener(name.slice(2), value);
    else if (name in e && name !== "list") e[name] = value;
    else e.setAttribute(name, value);
  }
  e.append(...content);
  return e;
}
