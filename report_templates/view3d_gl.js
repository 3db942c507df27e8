// Draws meshes and clouds with WebGL, lit from the viewer's side. Knows nothing of the page.
const makePainter = (canvas) => {
  const gl = canvas.getContext('webgl', { antialias: true, alpha: true });
  if (!gl) return null;

  const shader = (kind, text) => {
    const made = gl.createShader(kind);
    gl.shaderSource(made, text);
    gl.compileShader(made);
    return made;
  };
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, `
    attribute vec3 point, normal, colour;
    uniform mat3 turn;
    uniform vec3 middle;
    uniform vec2 zoom;
    uniform float dot_size;
    varying vec3 shade;
    void main() {
      vec3 p = turn * (point - middle);
      vec3 n = turn * normal;
      float light = 0.45 + 0.55 * abs(dot(normalize(n + vec3(0.0, 0.0, 1e-4)), normalize(vec3(-0.3, 0.5, 0.8))));
      shade = colour * light;
      gl_Position = vec4(p.xy * zoom, -0.2 * p.z, 1.0);
      gl_PointSize = dot_size;
    }`));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, `
    precision mediump float;
    varying vec3 shade;
    void main() { gl_FragColor = vec4(shade, 1.0); }`));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return null;
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);

  const buffer = (kind, data) => {
    const made = gl.createBuffer();
    gl.bindBuffer(kind, made);
    gl.bufferData(kind, data, gl.STATIC_DRAW);
    return made;
  };
  const feed = (name, from, type, normalized) => {
    const at = gl.getAttribLocation(program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, from);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, 3, type, normalized, 0, 0);
  };

  return {
    // points: Float32Array, normals: Int8Array, triangles: Uint16Array, empty for a cloud.
    mesh: (points, normals, triangles) => ({
      points: buffer(gl.ARRAY_BUFFER, points),
      normals: buffer(gl.ARRAY_BUFFER, normals),
      triangles: triangles.length ? buffer(gl.ELEMENT_ARRAY_BUFFER, triangles) : null,
      count: triangles.length || points.length / 3,
      colours: null,
    }),
    // colours: Uint8Array, three a point.
    paint: (mesh, colours) => { mesh.colours = buffer(gl.ARRAY_BUFFER, colours); },
    // camera: { turn: nine numbers by column, middle: [x, y, z], scale: 1/m to half the height }.
    draw: (meshes, camera) => {
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      const uniform = (name) => gl.getUniformLocation(program, name);
      gl.uniformMatrix3fv(uniform('turn'), false, camera.turn);
      gl.uniform3fv(uniform('middle'), camera.middle);
      gl.uniform2f(uniform('zoom'), camera.scale * canvas.height / canvas.width, camera.scale);
      gl.uniform1f(uniform('dot_size'), Math.max(2, camera.scale * canvas.height * 0.004));
      for (const mesh of meshes) {
        feed('point', mesh.points, gl.FLOAT, false);
        feed('normal', mesh.normals, gl.BYTE, true);
        feed('colour', mesh.colours, gl.UNSIGNED_BYTE, true);
        if (mesh.triangles) {
          gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.triangles);
          gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_SHORT, 0);
        } else {
          gl.drawArrays(gl.POINTS, 0, mesh.count);
        }
      }
    },
  };
};
