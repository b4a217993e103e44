// WebGL 2: the programs of the graphics processor, and what they draw into.

const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
let programs, pickBuffer, smoothBuffer;  // programs: by what they draw
const cameraChanges = { count: 0 };

function framebuffer(samples, width, height) {
  const frame = gl.createFramebuffer(), buffers = [];
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  for (const [format, place] of [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
    const buffer = gl.createRenderbuffer();
    buffers.push(buffer);
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
  }
  return { frame, buffers, width, height };
}
function startDrawing() {
  programs = new Map();
  pickBuffer = framebuffer(0, 1, 1).frame;
  smoothBuffer = null;
}

/// The program that draws what is named, such as "SMOOTH VALUES".
function programFor(names) {
  const known = programs.get(names);
  if (known) return known;
  const program = gl.createProgram(), defines = names.split(" ").map((n) => `#define ${n}`).join("\n");
  for (const [type, text] of [[gl.VERTEX_SHADER, shaders.surface_vert], [gl.FRAGMENT_SHADER, shaders.surface_frag]]) {
    const s = gl.createShader(type);
    gl.shaderSource(s, text.trim().replace("\n", `\n${defines}\n`));
    gl.compileShader(s);
    if (!gl.getShaderParameter(s, gl.COMPILE_STATUS) && !gl.isContextLost()) throw new Error(gl.getShaderInfoLog(s));
    gl.attachShader(program, s);
  }
  ["position", "normal", "flags", "value", "paint", "sides", "texture_place"].forEach((name, i) => gl.bindAttribLocation(program, i, name));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(program));
  const made = { program, uniforms: {}, camera: -1 };
  for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
    const name = gl.getActiveUniform(program, i).name.replace(/\[0\]$/, "");
    made.uniforms[name] = gl.getUniformLocation(program, name);
  }
  programs.set(names, made);
  return made;
}

/// Takes a program, and tells it where the camera and the planes are if they moved.
function usedProgram(names) {
  const used = programFor(names), { program, uniforms: u } = used;
  gl.useProgram(program);
  if (used.camera === cameraChanges.count) return used;
  used.camera = cameraChanges.count;
  gl.uniformMatrix4fv(u.project, false, projection());
  const { right: r, up, back: b } = camera;
  gl.uniformMatrix3fv(u.turn, false, [r[0], up[0], b[0], r[1], up[1], b[1], r[2], up[2], b[2]]);
  gl.uniform1i(u.parallel, camera.parallel ? 1 : 0);
  gl.uniform3fv(u.eye, eyeOf());
  const planes = new Float32Array(16);
  for (const p of planesOn()) planes.set(unitPlane(p), 4 * p.k);
  gl.uniform4fv(u.planes ?? null, planes);
  ["map", "ball", "picture"].forEach((name, i) => gl.uniform1i(u[name] ?? null, i));
  return used;
}
