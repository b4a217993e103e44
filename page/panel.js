// The controls beside the picture.

const panel = byId("panel");

/// What an input changes is drawn again: "view", the colours of a thing, or its polygons.
function changed(what, thing) {
  if (what === "polygons") for (const t of thing ? [thing] : things) if (t.mesh) sendThing(t);
  if (what === "colors") sendColors(thing);
  if (what === "map") sendMap(thing);
  showLegend();
  showAreas();
  redraw();
}

const row = (...content) => make("div", { className: "row" }, ...content);
const fittedRow = (...content) => make("div", { className: "row fitted" }, ...content);
const labelled = (text, input) => make("label", {}, text, input);
const checkbox = (text, value, set) => make("label", {}, make("input", { type: "checkbox", checked: value, onchange: (e) => set(e.target.checked) }), text);
const slider = (text, value, low, high, step, set) => make("input", { type: "range", min: low, max: high, step, value, "aria-label": text,
  oninput: (e) => set(Number(e.target.value)) });
const number = (text, value, set, step = "any") => make("input", { type: "number", step, value: Number.isFinite(value) ? Number(value.toPrecision(5)) : value, "aria-label": text,
  onchange: (e) => { if (e.target.value !== "" && Number.isFinite(Number(e.target.value))) set(Number(e.target.value)); } });
const select = (text, choices, value, set) => {
  const s = make("select", { "aria-label": text, onchange: (e) => set(e.target.value) }, ...choices.map(([v, name]) => make("option", { value: v, textContent: name, dir: "auto" })));
  s.value = value;
  return s;
};
const button = (text, press, title = "") => make("button", { type: "button", title, onclick: press }, text);
const section = (name, open, ...content) => make("details", { open }, make("summary", {}, name), ...content);

const byteOf = (x) => Math.round(255 * Math.min(1, Math.max(0, x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055)));
const hexOf = (c) => `#${c.map((x) => byteOf(x).toString(16).padStart(2, "0")).join("")}`;
const linearOf = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255).map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));

/// Where the values of a field are, as the choice of colours names it.
const nameOfField = (f) => (["vert", "edge", "face", "poly", "corner"].includes(f.at) ? `${f.name} (${f.at}s)` : f.name);

function thingControls(thing) {
  const box = make("fieldset", { id: `thing${thing.index}` }), fill = () => box.replaceChildren(...content());
  const content = () => {
    const parts = [make("legend", { dir: "auto" }, thing.name),
      row(checkbox("shown", thing.visible, (x) => { thing.visible = x; changed("view"); }),
        checkbox("edges", thing.wire, (x) => { thing.wire = x; changed("view"); }),
        checkbox("flat", thing.flat, (x) => { thing.flat = x; changed("view"); }),
        ...(thing.texture ? [checkbox("texture", thing.textured, (x) => { thing.textured = x; changed("view"); })] : [])),
      row("opacity", slider(`opacity of ${thing.name}`, thing.opacity, 0, 1, 0.01, (x) => { thing.opacity = x; changed("view"); }))];
    const numeric = thing.fields.map((f, i) => [String(i), nameOfField(f), f]).filter(([, , f]) => f.numbers && f.at !== "mesh");
    const choices = [["color", "one colour"], ...(thing.painted ? [["painted", "own colours"]] : []), ...numeric];
    parts.push(row("colours", select(`colours of ${thing.name}`, choices, thing.chosen, (v) => { thing.choose(v); fill(); changed("colors", thing); })));
    if (thing.chosen === "color") parts.push(row(labelled("colour", make("input", { type: "color", value: hexOf(thing.color),
      oninput: (e) => { thing.color = linearOf(e.target.value); changed("view"); } }))));
    const f = thing.field;
    if (f && f.width > 1) parts.push(row("show", select("component", componentsOf(f).map((c) => [c, c]), thing.component || componentsOf(f)[0],
      (c) => { thing.component = c; thing.fitRange(); fill(); changed("colors", thing); })));
    if (f && !f.labels) parts.push(...scaleControls(thing, fill));
    const vectors = thing.fields.map((g, i) => [String(i), nameOfField(g), g]).filter(([, , g]) => g.numbers && (g.width === 2 || g.width === 3) && (g.at === "vert" || g.at === "poly") && g.numbers !== thing.texture?.numbers);
    if (vectors.length) parts.push(row("arrows", select(`arrows of ${thing.name}`, [["", "none"], ...vectors], thing.arrows, (v) => { thing.arrows = v; changed("polygons", thing); })));
    return parts;
  };
  fill();
  return box;
}

function scaleControls(thing, fill) {
  const maps = [...(thing.ownMap ? [["-1", "as in the program"]] : []), ...scene.maps.map((m, i) => [String(i), m.name])];
  const low = thing.scale[0][0], high = thing.scale[thing.scale.length - 1][0];
  const range = (a, b) => { thing.setRange(a, b); fill(); changed("colors", thing); };
  return [row("map", select(`colour map of ${thing.name}`, maps, String(thing.map), (v) => { thing.map = Number(v); changed("map", thing); })),
    fittedRow("from", number("lowest value", low, (x) => range(x, Math.max(x, high))), "to", number("highest value", high, (x) => range(Math.min(low, x), x)),
      button("all", () => { thing.fitRange(); fill(); changed("colors", thing); }, "The range of all values")),
    row("bands", number("white bands", thing.bands, (x) => { thing.bands = Math.max(0, Math.round(x)); changed("view"); }, 1),
      "lines", number("iso-lines", thing.lines, (x) => { thing.lines = Math.max(0, Math.round(x)); changed("view"); }, 1))];
}

function planeControls(k) {
  const p = slicing.planes[k], name = ["x", "y", "z", "any"][k];
  const redo = () => changed(slicing.exact && !things.some((t) => t.mesh?.isVolume) ? "view" : "polygons");
  const value = make("output", { className: "soft", id: `offset${k}` });
  const show = () => { const { offset } = planeOf(k); value.textContent = textOf(Math.abs(offset) < 1e-9 * scene.radius ? 0 : Number((p.keepsAbove ? -offset : offset).toPrecision(5))); };
  show();
  const parts = [fittedRow(checkbox(name, p.on, (x) => { p.on = x; redo(); }),
    slider(`place of the cut along ${name}`, p.t, 0, 1, 0.001, (x) => { p.t = x; p.on = true; parts[0].querySelector("input").checked = true; show(); redo(); }),
    value, checkbox("above", p.keepsAbove, (x) => { p.keepsAbove = x; redo(); }))];
  if (k === 3) parts.push(fittedRow(...[0, 1, 2].map((i) => number(`direction ${"xyz"[i]}`, slicing.direction[i], (x) => { slicing.direction[i] = x; show(); redo(); })),
    button("from view", () => { slicing.direction = camera.back.map((x) => Number(x.toPrecision(4))); showPanel(); redo(); }, "The direction to the viewer")));
  return parts;
}

function filterControls(thing) {
  const f = thing.filter, redo = () => changed("polygons", thing), fields = thing.polyFields;
  const parts = [make("legend", { dir: "auto" }, thing.name),
    row("layers peeled off", number(`layers peeled off ${thing.name}`, f.layers, (x) => { f.layers = Math.max(0, Math.round(x)); redo(); }, 1))];
  if (fields.length) {
    const fit = () => { [f.low, f.high] = rangeOf(fields[f.field].numbers); };
    if (!f.on) fit();
    const box = make("div"), fill = () => box.replaceChildren(
      row(checkbox("only polys with", f.on, (x) => { f.on = x; redo(); }), select("value of polys", fields.map((g, i) => [String(i), g.name]), String(f.field), (v) => { f.field = Number(v); fit(); fill(); redo(); })),
      fittedRow("from", number("lowest shown", f.low, (x) => { f.low = x; redo(); }), "to", number("highest shown", f.high, (x) => { f.high = x; redo(); })),
      row("or labels", make("input", { type: "text", value: f.labels, placeholder: "1 2 5", "aria-label": "labels shown", onchange: (e) => { f.labels = e.target.value; f.on = f.on || f.labels !== ""; fill(); redo(); } })));
    fill();
    parts.push(box);
  }
  return make("fieldset", {}, ...parts);
}

function showAreas() {
  const areas = things.flatMap((t) => t.cutAreas ?? []), hidden = things.filter((t) => t.mesh && t.numShown !== undefined);
  const texts = hidden.map((t) => `${t.numShown} polys shown`);
  if (areas.length) texts.push(`area of the cut: ${areas.map((a) => textOf(a)).join(", ")}`);
  byId("areas")?.replaceChildren(texts.join("; "));
}

function showPicked() {
  const box = byId("picked");
  if (!box) return;
  const rows = picked ? describe(picked) : [];
  if (measured.length === 2) rows.push(["distance", textOf(norm(sub(measured[0], measured[1])) * scene.radius)]);
  box.replaceChildren(...rows.flatMap(([name, value]) => [make("dt", { dir: "auto" }, name), make("dd", { dir: "auto" }, value)]));
  const isolated = (text) => `\u2068${text.slice(0, 60)}\u2069`;  // its direction does not change that of the others
  const values = picked ? valueRows(picked.thing, picked.kind, picked.index).slice(0, 4).map((r) => `, ${r.map(isolated).join(" ")}`) : [];
  say(picked ? rows.slice(0, 2).map(([, value]) => isolated(value)).join(", ") + values.join("") : measured.length === 2 ? `${rows.at(-1)[0]} ${rows.at(-1)[1]}` : "");
}

function pickControls() {
  const meshes = things.filter((t) => t.mesh);
  if (!meshes.length) return [make("p", { className: "soft" }, "A click names the object. With inspect, a mesh also tells its elements and values.")];
  const go = { thing: meshes[0], kind: "poly", index: 0 };
  const jump = () => { if (goTo(go.thing, go.kind, go.index)) showPicked(); else say(`there is no ${go.kind} ${go.index}`); redo(); }, redo = redraw;
  return [row("a click picks", select("what a click picks", [["any", "what is nearest"], ["vert", "verts"], ["edge", "edges"], ["face", "faces"], ["poly", "polys"]], wanted,
    (v) => { wanted = v; })),
    row(...(meshes.length > 1 ? [select("mesh", meshes.map((t, i) => [String(i), t.name]), "0", (v) => { go.thing = meshes[Number(v)]; })] : []),
      select("kind of element", ["vert", "edge", "face", "poly"].map((k) => [k, k]), go.kind, (v) => { go.kind = v; }),
      make("input", { type: "number", id: "goIndex", min: 0, step: 1, value: 0, "aria-label": "index of the element", oninput: (e) => { go.index = Number(e.target.value); },
        onkeydown: (e) => { if (e.key === "Enter") jump(); } }), button("go", jump, "Shows this element")),
    make("p", { className: "soft" }, "Shift and click measures a distance.")];
}

function viewControls() {
  return [row(...["+x", "−x", "+y", "−y", "+z", "−z"].map((name, i) => button(name, () => press(String(i + 1)), `Looks along the axis (${i + 1})`))),
    row(button("perspective", () => press("p"), "Perspective or orthographic (P)"), button("reset", () => press("r"), "The first view (R)"),
      button("dark", () => press("d"), "Light or dark (D)")),
    row(button("picture", () => press("s"), "Saves a PNG file (S)"), button("copy view", () => press("v"), "An address that shows this view (V)"))];
}

function showPanel() {
  const meshes = things.filter((t) => t.mesh);
  panel.replaceChildren(
    section("Objects", true, ...(things.length ? things.map(thingControls) : [make("p", { className: "soft" }, "The scene is empty.")])),
    ...(meshes.length ? [section("Cuts", innerWidth > 700, row(select("kind of cut", [["", "whole polys"], ["exact", "cut exactly"]], slicing.exact ? "exact" : "",
      (v) => { slicing.exact = v !== ""; changed("polygons"); })), ...[0, 1, 2, 3].flatMap(planeControls), make("p", { id: "areas", className: "soft" }), ...meshes.map(filterControls))] : []),
    section("Inspect", true, ...pickControls(), make("dl", { id: "picked" })),
    section("View", innerWidth > 700, ...viewControls()));
  showAreas();
  showPicked();
}

/// The legend of the first thing that shows values.
function showLegend() {
  const box = byId("legend"), thing = things.find((t) => t.visible && t.field);
  box.hidden = !thing;
  if (!thing) return;
  const f = thing.field, title = make("figcaption", { dir: "auto" }, f.width > 1 ? `${f.name}, ${thing.component || componentsOf(f)[0]}` : f.name);
  if (thing.isLabels) {
    const all = [...new Set(f.numbers)].map(labelOf).filter((x) => !Number.isNaN(x)).sort((a, b) => a - b).slice(0, 20);
    const colorOf = (x) => `rgb(${[0, 1, 2].map((c) => scene.labelColors[3 * (x % 20) + c]).join()})`;
    box.replaceChildren(title, make("ul", {}, ...all.map((x) => { const i = make("i"); i.style.background = colorOf(x); return make("li", {}, i, String(x)); })));
    return;
  }
  const bar = make("canvas", { width: 1, height: 256 }), paint = bar.getContext("2d"), colors = thing.mapColors;
  for (let y = 0; y < 256; ++y) { paint.fillStyle = `rgb(${colors.slice(3 * (255 - y), 3 * (256 - y)).join()})`; paint.fillRect(0, y, 1, 1); }
  const ticks = scaleTicks(thing.scale, 6).map(([x, text]) => { const s = make("span", {}, text); s.style.top = `${100 - 100 * placeOf(thing.scale, x)}%`; return s; });
  box.replaceChildren(title, bar, make("div", { className: "ticks" }, ...ticks));
  if (thing.numbers.every(Number.isFinite)) return;
  const grey = make("i");
  grey.style.background = hexOf(thing.data.look.no_value);
  box.append(make("p", {}, grey, "no finite value"));
}

const say = (text) => { byId("message").textContent = text; };
