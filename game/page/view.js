// SPDX-License-Identifier: MIT
// Draws a match as one peer sees it. Floats are fine here, because nothing flows back from this
// file.
import * as three from 'three';

const sideColors = [0xd8483c, 0x3b7be0];
const catapultX = [9.5, 6.2], catapultY = 2.6, gravity = 10, speedOfPower = 22 / 256, depth = 1.5;
const calm = matchMedia('(prefers-reduced-motion: reduce)');

export const directionOf = (player) => (player % 2 === 0 ? 1 : -1);

function texture(width, height, paint) {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  paint(canvas.getContext('2d'), width, height);
  const result = new three.CanvasTexture(canvas);
  result.colorSpace = three.SRGBColorSpace;
  return result;
}
// Both peers have the same grain.
function noise(seed) {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}
const wood = (context, width, height) => {
  const random = noise(7);
  context.fillStyle = '#b98850';
  context.fillRect(0, 0, width, height);
  for (let i = 0; i < 46; ++i) {
    context.fillStyle = `rgba(80, 45, 12, ${0.05 + 0.13 * random()})`;
    context.fillRect(0, random() * height, width, 1 + 2 * random());
  }
  context.strokeStyle = 'rgba(60, 32, 8, 0.75)';
  context.lineWidth = 5;
  context.strokeRect(0, 0, width, height);
};
const stone = (context, width, height) => {
  const random = noise(11);
  context.fillStyle = '#98a0ab';
  context.fillRect(0, 0, width, height);
  for (let i = 0; i < 240; ++i) {
    const light = random() < 0.5 ? 255 : 20;
    context.fillStyle = `rgba(${light}, ${light}, ${light}, ${0.09 * random()})`;
    const size = 2 + 9 * random();
    context.fillRect(random() * width, random() * height, size, size);
  }
  context.strokeStyle = 'rgba(40, 45, 55, 0.7)';
  context.lineWidth = 5;
  context.strokeRect(0, 0, width, height);
};
const sky = (context, width, height) => {
  const gradient = context.createLinearGradient(0, 0, 0, height);
  gradient.addColorStop(0, '#4d8fd6');
  gradient.addColorStop(0.55, '#a9d0ee');
  gradient.addColorStop(0.8, '#f8e3bd');
  context.fillStyle = gradient;
  context.fillRect(0, 0, width, height);
};

function ridge(color, z, base, height, seed) {
  const random = noise(seed), shape = new three.Shape();
  shape.moveTo(-90, -20);
  for (let x = -90; x <= 90; x += 9) shape.lineTo(x, base + height * random());
  shape.lineTo(90, -20);
  const mesh = new three.Mesh(new three.ShapeGeometry(shape), new three.MeshBasicMaterial({ color, fog: false }));
  mesh.position.z = z;
  return mesh;
}

export class View {
  constructor(canvas, controlled) {
    this.canvas = canvas;
    this.controlled = controlled;  // players whose shots are predicted
    this.renderer = new three.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.shadowMap.enabled = true;
    this.scene = new three.Scene();
    this.scene.background = texture(4, 256, sky);
    this.camera = new three.PerspectiveCamera(22, 2, 1, 300);
    const sun = new three.DirectionalLight(0xfff2dc, 2.6);
    sun.position.set(-14, 34, 26);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 1024);
    Object.assign(sun.shadow.camera, { left: -30, right: 30, top: 22, bottom: -22, near: 5, far: 90 });
    sun.shadow.bias = -0.001;
    this.scene.add(sun, new three.HemisphereLight(0xcfe4ff, 0x6d6250, 1.5));
    this.scene.add(ridge(0x9db7c9, -40, 7, 9, 5), ridge(0x7f9f8f, -28, 3, 6, 23));
    this.materials = {
      wood: new three.MeshStandardMaterial({ map: texture(128, 128, wood), roughness: 0.85 }),
      stone: new three.MeshStandardMaterial({ map: texture(128, 128, stone), roughness: 0.95 }),
      rock: new three.MeshStandardMaterial({ color: 0x7d8378, roughness: 1 }),
      grass: new three.MeshStandardMaterial({ color: 0x6f9b4a, roughness: 1 }),
      gold: new three.MeshStandardMaterial({ color: 0xf2c23e, metalness: 0.45, roughness: 0.35, side: three.DoubleSide }),
      skin: new three.MeshStandardMaterial({ color: 0xf0c8a0, roughness: 0.8 }),
      timber: new three.MeshStandardMaterial({ color: 0x70481f, roughness: 0.9 }),
      robe: sideColors.map((color) => new three.MeshStandardMaterial({ color, roughness: 0.7 })),
      ball: sideColors.map((color) => new three.MeshStandardMaterial(
        { color: new three.Color(color).lerp(new three.Color(0x22262e), 0.55), roughness: 0.45, metalness: 0.2 })),
      accused: new three.MeshStandardMaterial({ color: 0xff2a2a, emissive: 0xb00000, roughness: 0.6 }),
    };
    this.box = new three.BoxGeometry(1, 1, 1);
    this.sphere = new three.SphereGeometry(1, 20, 14);
    this.crown = new three.CylinderGeometry(0.36, 0.3, 0.24, 6, 1, true);
    this.pieces = new Map();
    this.slings = [];
    this.clouds = this.addClouds();
    this.addSparks();
    this.accused = -1;
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || (width === this.width && height === this.height)) return;
    this.width = width;
    this.height = height;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const distance = Math.max(21.5 / (half * this.camera.aspect), 9.5 / half);
    this.camera.position.set(0, 8.2, distance);
    this.camera.lookAt(0, -1.6 + half * distance * 0.93, 0);
    this.camera.updateProjectionMatrix();
  }

  addSling(player) {
    const group = new three.Group();
    group.position.set(-directionOf(player) * catapultX[player >> 1], 0, 0);
    const bar = (radius, length, x, y, turn) => {
      const mesh = new three.Mesh(new three.CylinderGeometry(radius, radius, length, 10), this.materials.timber);
      mesh.position.set(x, y, 0);
      mesh.rotation.z = turn;
      mesh.castShadow = true;
      group.add(mesh);
    };
    bar(0.2, 1.0, 0, 1.65, 0);
    bar(0.16, 1.0, 0.32, 2.45, -0.55);
    bar(0.16, 1.0, -0.32, 2.45, 0.55);
    const band = new three.Line(
      new three.BufferGeometry().setAttribute('position', new three.BufferAttribute(new Float32Array(9), 3)),
      new three.LineBasicMaterial({ color: 0x3a1d10 }));
    band.frustumCulled = false;
    const stoneBall = new three.Mesh(this.sphere, this.materials.ball[player % 2]);
    stoneBall.scale.setScalar(0.45);
    stoneBall.castShadow = true;
    group.add(band, stoneBall);
    const dots = [];
    for (let i = 0; i < 16; ++i) {
      const dot = new three.Mesh(this.sphere, new three.MeshBasicMaterial(
        { color: 0xffffff, transparent: true, opacity: 0.85 - 0.045 * i }));
      dot.scale.setScalar(0.13 - 0.004 * i);
      group.add(dot);
      dots.push(dot);
    }
    this.scene.add(group);
    return { group, band, ball: stoneBall, dots };
  }

  addClouds() {
    const puff = texture(64, 64, (context) => {
      const gradient = context.createRadialGradient(32, 32, 4, 32, 32, 31);
      gradient.addColorStop(0, 'rgba(255,255,255,0.85)');
      gradient.addColorStop(1, 'rgba(255,255,255,0)');
      context.fillStyle = gradient;
      context.fillRect(0, 0, 64, 64);
    });
    const random = noise(31), clouds = [];
    for (let i = 0; i < 6; ++i) {
      const cloud = new three.Group();
      for (let k = 0; k < 5; ++k) {
        const sprite = new three.Sprite(new three.SpriteMaterial({ map: puff, depthWrite: false, opacity: 0.75 }));
        sprite.scale.set(7 + 4 * random(), 3.5 + 2 * random(), 1);
        sprite.position.set(3 * (k - 2) + random(), random(), 0);
        cloud.add(sprite);
      }
      cloud.position.set(-45 + 16 * i, 13 + 7 * random(), -24);
      this.scene.add(cloud);
      clouds.push(cloud);
    }
    return clouds;
  }

  addSparks() {
    this.sparks = [];
    const count = 160;
    this.sparkMesh = new three.InstancedMesh(this.box, new three.MeshBasicMaterial(), count);
    this.sparkMesh.frustumCulled = false;
    for (let i = 0; i < count; ++i) {
      this.sparks.push({ life: 0, x: 0, y: 0, z: 0, vx: 0, vy: 0, vz: 0, size: 0 });
      this.sparkMesh.setColorAt(i, new three.Color(0xffffff));
    }
    this.nextSpark = 0;
    this.scene.add(this.sparkMesh);
  }

  // Dust or confetti, purely visual.
  burst(x, y, count, speed, colors) {
    if (calm.matches) return;
    for (let i = 0; i < count; ++i) {
      const at = this.nextSpark++ % this.sparks.length, turn = Math.random() * 6.28, push = speed * Math.random();
      Object.assign(this.sparks[at], { life: 1, x, y, z: 1, size: 0.12 + 0.16 * Math.random(),
        vx: push * Math.cos(turn), vy: push * Math.sin(turn) + speed * 0.4, vz: push * (Math.random() - 0.3) });
      this.sparkMesh.setColorAt(at, new three.Color(colors[i % colors.length]));
    }
    this.sparkMesh.instanceColor.needsUpdate = true;
  }

  make(piece) {
    const { kind, owner } = piece, group = new three.Group();
    const add = (geometry, material, x, y, z, sx, sy, sz) => {
      const mesh = new three.Mesh(geometry, material);
      mesh.position.set(x, y, z);
      mesh.scale.set(sx, sy, sz);
      mesh.castShadow = mesh.receiveShadow = true;
      group.add(mesh);
      return mesh;
    };
    const w = 2 * piece.halfX, h = 2 * piece.halfY;
    if (kind === 'ball') {
      add(this.sphere, this.materials.ball[owner], 0, 0, 0, piece.halfX, piece.halfX, piece.halfX);
      add(this.box, this.materials.gold, 0, 0, 0.4, 0.5, 0.12, 0.12);
    } else if (kind === 'king') {
      add(this.box, this.materials.robe[owner], 0, -0.22, 0, 0.9, 0.96, 0.8);
      add(this.box, this.materials.gold, 0, -0.3, 0, 0.94, 0.12, 0.84);
      add(this.sphere, this.materials.skin, 0, 0.42, 0, 0.36, 0.36, 0.36);
      for (const side of [-0.12, 0.12]) add(this.sphere, this.materials.timber, side, 0.45, 0.33, 0.055, 0.07, 0.05);
      add(this.crown, this.materials.gold, 0, 0.72, 0, 1, 1, 1);
      for (let i = 0; i < 6; ++i) {
        const turn = (i / 6) * 6.283;
        add(this.sphere, this.materials.gold, 0.34 * Math.sin(turn), 0.86, 0.34 * Math.cos(turn), 0.08, 0.08, 0.08);
      }
    } else if (kind === 'rock') {
      const ground = piece.halfX > 20;
      const wide = ground ? 240 : w, deep = ground ? 60 : depth + 1.2 + h * 0.2;
      add(this.box, ground ? this.materials.grass : this.materials.rock, 0, 0, ground ? -22 : 0, wide, h, deep);
      if (!ground && piece.halfX < 4) add(this.box, this.materials.grass, 0, piece.halfY, 0, w + 0.1, 0.14, deep + 0.1);
    } else {
      add(this.box, this.materials[kind], 0, 0, 0, w - 0.02, h - 0.02, depth);
    }
    this.scene.add(group);
    return { key: keyOf(piece), group, last: null };
  }

  update(match) {
    const seen = new Set();
    for (const piece of match.pieces) {
      let drawn = this.pieces.get(piece.index);
      if (drawn && drawn.key !== keyOf(piece)) {
        this.scene.remove(drawn.group);
        drawn = null;
      }
      if (!drawn) {
        drawn = this.make(piece);
        drawn.group.position.set(piece.x, piece.y, 0);
        this.pieces.set(piece.index, drawn);
      }
      seen.add(piece.index);
      const { position } = drawn.group;
      const dx = piece.x - position.x, dy = piece.y - position.y;
      // Smooth the correction of a wrong prediction.
      const share = Math.hypot(dx, dy) > 3 ? 1 : 0.6;
      if (piece.kind === 'ball') this.noteHit(drawn, piece, match.tick);
      position.x += dx * share;
      position.y += dy * share;
      drawn.group.rotation.z = piece.turn;
      if (piece.index === this.accused && !drawn.isAccused) {
        drawn.isAccused = true;
        drawn.group.children.forEach((mesh) => { mesh.material = this.materials.accused; });
      }
    }
    for (const [index, drawn] of this.pieces) {
      if (seen.has(index)) continue;
      this.scene.remove(drawn.group);
      this.pieces.delete(index);
    }
    while (this.slings.length < match.catapults.length) this.slings.push(this.addSling(this.slings.length));
    this.slings.forEach((sling, i) => {
      sling.group.visible = i < match.catapults.length;
      if (sling.group.visible) this.updateSling(sling, i, match);
    });
    this.wind = match.wind * 60;
  }

  // A ball that deviates from free fall has hit something.
  noteHit(drawn, piece, tick) {
    const { last } = drawn, ticks = tick - (last?.tick ?? tick);
    if (ticks === 0 && last) return;
    const now = { tick, x: piece.x, y: piece.y, vx: 0, vy: 0, isFlying: false };
    if (last && ticks > 0) {
      now.vx = (60 * (piece.x - last.x)) / ticks;
      now.vy = (60 * (piece.y - last.y)) / ticks;
      now.isFlying = true;
      const bend = Math.hypot(now.vx - last.vx, now.vy - last.vy + (gravity * ticks) / 60);
      if (last.isFlying && bend > 3.5) {
        this.burst(piece.x, piece.y, Math.min(14, 3 + bend), 3, [0xd9c7a4, 0xa99674, 0x8f8a80]);
        this.onHit?.(Math.min(1, bend / 16));
      }
    }
    drawn.last = now;
  }

  updateSling(sling, player, match) {
    const { angle, power, reload } = match.catapults[player], forward = directionOf(player);
    const turn = (angle / 65536) * 2 * Math.PI;
    const aim = [forward * Math.cos(turn), Math.sin(turn)];
    const isReady = reload === 0 && match.pause === 0;
    const pull = isReady ? 0.6 + (1.5 * power) / 255 : 0;
    const x = -aim[0] * pull, y = catapultY + 0.3 - aim[1] * pull;
    sling.ball.visible = isReady;
    sling.ball.position.set(x, y, 0);
    const points = sling.band.geometry.attributes.position;
    points.setXYZ(0, 0.55, catapultY + 0.2, 0.1);
    points.setXYZ(1, x - aim[0] * 0.4, y - aim[1] * 0.4, 0.3);
    points.setXYZ(2, -0.55, catapultY + 0.2, 0.1);
    points.needsUpdate = true;
    const speed = power * speedOfPower;
    sling.dots.forEach((dot, k) => {
      const time = 0.08 * (k + 1);
      dot.visible = isReady && this.controlled.includes(player);
      dot.position.set(aim[0] * speed * time + 30 * match.wind * time * time,
        catapultY + aim[1] * speed * time - (gravity / 2) * time * time, 0.2);
    });
  }

  draw(seconds) {
    this.resize();
    for (const cloud of this.clouds) {
      if (!calm.matches) cloud.position.x += (0.3 + (this.wind ?? 0)) * seconds * 0.6;
      if (cloud.position.x > 52) cloud.position.x = -52;
      if (cloud.position.x < -52) cloud.position.x = 52;
    }
    const place = new three.Matrix4();
    this.sparks.forEach((spark, i) => {
      spark.life = Math.max(0, spark.life - seconds * 1.1);
      spark.vy -= 9 * seconds;
      spark.x += spark.vx * seconds;
      spark.y = Math.max(0.05, spark.y + spark.vy * seconds);
      spark.z += spark.vz * seconds;
      const size = spark.size * Math.min(1, 2 * spark.life);
      this.sparkMesh.setMatrixAt(i, place.makeScale(size, size, size).setPosition(spark.x, spark.y, spark.z));
    });
    this.sparkMesh.instanceMatrix.needsUpdate = true;
    this.renderer.render(this.scene, this.camera);
  }

  accuse(index) {
    this.accused = index;
    for (const drawn of this.pieces.values()) {
      if (!drawn.isAccused) continue;
      drawn.key = '';  // forces it to be rebuilt
    }
  }
}

const keyOf = (piece) => `${piece.index} ${piece.generation} ${piece.kind}`;
