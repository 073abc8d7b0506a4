// The arm's paint: sky, sun and a little gloss in a dozen operations a pixel, since a projector's laptop may draw in software.
import * as THREE from 'three';

const vertexShader = /* glsl */ `
  attribute float paint;
  uniform vec3 colours[4];
  varying vec3 vNormal;
  varying vec3 vToEye;
  varying vec3 vColour;
  void main() {
    vec4 world = modelMatrix * vec4(position, 1.0);
    vNormal = normalize(normal);
    vToEye = cameraPosition - world.xyz;
    vColour = paint < 0.5 ? colours[0] : paint < 1.5 ? colours[1] : paint < 2.5 ? colours[2] : colours[3];
    gl_Position = projectionMatrix * viewMatrix * world;
  }`;

const fragmentShader = /* glsl */ `
  uniform float opacity;
  uniform vec3 sky;
  uniform vec3 ground;
  uniform float gloss;
  varying vec3 vNormal;
  varying vec3 vToEye;
  varying vec3 vColour;
  const vec3 SUN = vec3(0.332, -0.443, 0.831);
  const vec3 FILL = vec3(-0.788, 0.394, 0.473);
  void main() {
    vec3 n = normalize(vNormal), e = normalize(vToEye);
    float sun = max(dot(n, SUN), 0.0), fill = max(dot(n, FILL), 0.0);
    vec3 light = mix(ground, sky, 0.5 + 0.5 * n.z) + 0.62 * sun + 0.2 * fill;
    float shine = gloss * pow(max(dot(n, normalize(SUN + e)), 0.0), 28.0);
    gl_FragColor = vec4(vColour * light + shine, opacity);
    #include <colorspace_fragment>
  }`;

/** A ghost's paint: the same light, worked out at the corners only; seven translucent arms are many pixels. */
const veilVertexShader = /* glsl */ `
  attribute float paint;
  uniform vec3 colours[4];
  uniform vec3 sky;
  uniform vec3 ground;
  varying vec3 vColour;
  const vec3 SUN = vec3(0.332, -0.443, 0.831);
  void main() {
    vec3 n = normalize(normal);
    vec3 linear = (paint < 2.5 ? colours[0] : colours[3]) * (mix(ground, sky, 0.5 + 0.5 * n.z) + 0.75 * max(dot(n, SUN), 0.0));
    vColour = pow(linear, vec3(1.0 / 2.2));
    gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
  }`;
const veilFragmentShader = /* glsl */ `
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;

/** A material for the parts of arms; `repaint(link, joint, accent, dark, beyond)` sets its colours and the sky of the theme. */
export function matte({ opacity = 1, gloss = 0.16, veil = false } = {}) {
  const material = new THREE.ShaderMaterial({
    vertexShader: veil ? veilVertexShader : vertexShader,
    fragmentShader: veil ? veilFragmentShader : fragmentShader,
    transparent: opacity < 1,
    uniforms: {
      colours: { value: [0, 1, 2, 3].map(() => new THREE.Color()) },
      opacity: { value: opacity },
      gloss: { value: gloss },
      sky: { value: new THREE.Color(0.46, 0.46, 0.47) },
      ground: { value: new THREE.Color(0.2, 0.2, 0.21) },
    },
  });
  material.repaint = (link, joint, accent, dark, beyond = accent) => {
    [link, joint, accent, beyond].forEach((colour, i) => material.uniforms.colours.value[i].set(colour));
    material.uniforms.sky.value.setScalar(dark ? 0.36 : 0.47);
    material.uniforms.ground.value.setScalar(dark ? 0.1 : 0.2);
  };
  return material;
}

/** A ghost's outline: the far side of a slightly larger body, seen only beside the body itself, which is drawn before it. */
export function rim() {
  const material = new THREE.ShaderMaterial({
    vertexShader: /* glsl */ `
      attribute float paint;
      uniform vec3 colours[2];
      varying vec3 vColour;
      void main() {
        vColour = paint < 2.5 ? colours[0] : colours[1];
        gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      varying vec3 vColour;
      void main() {
        gl_FragColor = vec4(vColour, 0.85);
        #include <colorspace_fragment>
      }`,
    side: THREE.BackSide,
    transparent: true,
    depthWrite: false,
    uniforms: { colours: { value: [new THREE.Color(), new THREE.Color()] } },
  });
  material.repaint = (...two) => two.forEach((colour, i) => material.uniforms.colours.value[i].set(colour));
  return material;
}

/** A body's paint of one colour, wherever it stands; both sides of the faces of what is not closed. */
export function solid(closed) {
  const material = new THREE.ShaderMaterial({
    vertexShader: /* glsl */ `
      varying vec3 vNormal;
      varying vec3 vToEye;
      varying vec3 vColour;
      uniform vec3 colour;
      void main() {
        vec4 world = modelMatrix * vec4(position, 1.0);
        vNormal = mat3(modelMatrix) * normal;
        vToEye = cameraPosition - world.xyz;
        vColour = colour;
        gl_Position = projectionMatrix * viewMatrix * world;
      }`,
    fragmentShader: fragmentShader.replace(
      'vec3 n = normalize(vNormal),',
      'vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal),',
    ),
    side: closed ? THREE.FrontSide : THREE.DoubleSide,
    uniforms: {
      colour: { value: new THREE.Color() },
      opacity: { value: 1 },
      gloss: { value: 0.14 },
      sky: { value: new THREE.Color() },
      ground: { value: new THREE.Color() },
    },
  });
  material.colour = material.uniforms.colour.value;
  material.see = (opacity, dark) => {
    material.uniforms.opacity.value = opacity;
    material.transparent = opacity < 1;
    material.uniforms.sky.value.setScalar(dark ? 0.4 : 0.47);
    material.uniforms.ground.value.setScalar(dark ? 0.13 : 0.2);
  };
  return material;
}
