// Bodies, springs and what is held, in the frame of the part: they follow the modes.
import {
  BoxGeometry, CatmullRomCurve3, Group, Mesh, MeshStandardMaterial, OctahedronGeometry, Quaternion,
  SphereGeometry, TubeGeometry, Vector3,
} from 'three';

const colours = { mass: '#8a6d3b', spring: '#2f7d5b', held: '#5b6670' };
const turns = 7, smooth = 16; // of a coil, points of a turn

const solid = (geometry, colour) => new Mesh(geometry,
  new MeshStandardMaterial({ color: colour, roughness: 0.6, metalness: 0.1 }));

// A coil of length 1 along y from the origin.
function coil(radius, wire) {
  const points = [new Vector3(0, 0, 0)];
  for (let i = 0; i <= turns * smooth; ++i) {
    const angle = (2 * Math.PI * i) / smooth;
    points.push(new Vector3(radius * Math.cos(angle), 0.12 + (0.76 * i) / (turns * smooth), radius * Math.sin(angle)));
  }
  points.push(new Vector3(0, 1, 0));
  return solid(new TubeGeometry(new CatmullRomCurve3(points), turns * smooth * 2, wire, 6), colours.spring);
}

const up = new Vector3(0, 1, 0);

function stretch(spring, from, to) {
  const along = to.clone().sub(from);
  const length = along.length() || 1e-9;
  spring.position.copy(from);
  spring.quaternion.copy(new Quaternion().setFromUnitVectors(up, along.divideScalar(length)));
  spring.scale.set(1, length, 1);
}

// One symbol: what is drawn, where its name stands, and how it goes along with the motion of its ends.
function symbolOf(data, size) {
  const group = new Group();
  const ends = data.ends.map((end) => new Vector3(...end.at));
  const name = ends[0].clone();
  let follow;
  if (data.kind === 'mass') {
    const ball = solid(new SphereGeometry(data.radius, 32, 20), colours.mass);
    ball.material.transparent = true;
    ball.material.opacity = 0.85;
    group.add(ball);
    follow = ([at]) => { ball.position.copy(at); };
  } else if (data.kind === 'held') {
    const side = 0.03 * size;
    const block = solid(new BoxGeometry(side, side, side), colours.held);
    group.add(block);
    follow = ([at]) => { block.position.copy(at); };
  } else if (data.kind === 'ground' || ends.length < 2) {
    const foot = ends[0].clone().add(new Vector3(0, 0, -0.09 * size));
    const plate = solid(new BoxGeometry(0.05 * size, 0.05 * size, 0.004 * size), colours.held);
    plate.position.copy(foot);
    const spring = coil(0.012 * size, 0.002 * size);
    group.add(plate, spring);
    name.copy(foot);
    follow = ([at]) => { stretch(spring, foot, at); };
  } else if (ends[0].distanceTo(ends[1]) > 0.02 * size) {
    const spring = coil(0.015 * size, 0.0025 * size);
    group.add(spring);
    name.add(ends[1]).divideScalar(2);
    follow = ([from, to]) => { stretch(spring, from, to); };
  } else {
    const joint = solid(new OctahedronGeometry(0.015 * size), colours.spring);
    group.add(joint);
    follow = ([at]) => { joint.position.copy(at); };
  }
  const move = (mode, share) => follow(ends.map((at, i) => (mode < 0 ? at
    : at.clone().addScaledVector(new Vector3(...data.ends[i].moves[mode]), share))));
  move(-1, 0);
  return { group, name, move };
}

// Adds the symbols to `frame`; `size`: of the part, m.
export function addSymbols(list, frame, size) {
  return list.map((data) => {
    const symbol = symbolOf(data, size);
    frame.add(symbol.group);
    return { ...symbol, label: data.name };
  });
}
