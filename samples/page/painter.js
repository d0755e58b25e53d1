// SPDX-License-Identifier: MIT
//
// Draws lines and triangles in a canvas. Their colours already include the lighting.

const vertexShader = `#version 300 es
uniform mat4 view;
in vec3 place;
in vec4 colour;
out vec4 shade;
void main() { gl_Position = view * vec4(place, 1.0); shade = colour; }`;
const pixelShader = `#version 300 es
precision mediump float;
in vec4 shade;
out vec4 pixel;
void main() { pixel = shade; }`;

export class Painter {
  constructor(canvas) {
    const gl = canvas.getContext('webgl2', { antialias: true, alpha: false });
    if (!gl) throw new Error('this browser has no WebGL 2');
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, pixelShader]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    this.view = gl.getUniformLocation(program, 'view');
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    const place = gl.getAttribLocation(program, 'place'), colour = gl.getAttribLocation(program, 'colour');
    gl.enableVertexAttribArray(place);
    gl.enableVertexAttribArray(colour);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 16, 0);
    gl.vertexAttribPointer(colour, 4, gl.UNSIGNED_BYTE, true, 16, 12);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.polygonOffset(1, 1);  // edges are drawn over their own faces
    gl.clearColor(0xf4 / 255, 0xf6 / 255, 0xf8 / 255, 1);
    Object.assign(this, { canvas, gl });
  }

  /// Resizes the canvas to screen pixels. Returns width over height.
  fit() {
    const { canvas, gl } = this, density = Math.min(window.devicePixelRatio, 2);
    const width = Math.max(1, Math.round(canvas.clientWidth * density));
    const height = Math.max(1, Math.round(canvas.clientHeight * density));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    return width / height;
  }

  paint({ matrix, triangles, lines }) {
    const { gl } = this;
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(this.view, false, matrix);
    for (const [kind, bytes] of [[gl.TRIANGLES, triangles], [gl.LINES, lines]]) {
      if (kind === gl.TRIANGLES) gl.enable(gl.POLYGON_OFFSET_FILL); else gl.disable(gl.POLYGON_OFFSET_FILL);
      gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.STREAM_DRAW);
      gl.drawArrays(kind, 0, bytes.length / 16);
    }
  }
}
