// Motions of the sample: from closed forms and plain kinematics, with reactions of about the right size.

const rounded = (value) => Number(value.toFixed(6));
const vector = (...parts) => parts.map(rounded);
const times = (duration, count) => Array.from({length: count}, (_, i) => rounded(duration * i / (count - 1)));
const about = (axis, angle) => [Math.cos(angle / 2), ...axis.map((part) => part * Math.sin(angle / 2))].map(rounded);

/** A double pendulum of point masses, by the classical Runge-Kutta method. */
function doublePendulum() {
  const g = 9.81;
  const rates = ([a, b, u, v]) => {
    const [s, c] = [Math.sin(a - b), Math.cos(a - b)];
    const below = 2 - c * c;
    return [u, v, (-2 * g * Math.sin(a) + g * Math.sin(b) * c - s * (v * v + u * u * c)) / below, (2 * (g * Math.sin(a) * c - g * Math.sin(b) + s * u * u) + s * c * v * v) / below];
  };
  const plus = (x, k, h) => x.map((value, i) => value + h * k[i]);
  const t = times(10, 301);
  let x = [2.0, 1.2, 0, 0];
  const found = [];
  for (let i = 0; i < t.length; ++i) {
    found.push(x);
    for (let k = 0; k < 10; ++k) {
      const h = (t[1] - t[0]) / 10;
      const k1 = rates(x); const k2 = rates(plus(x, k1, h / 2)); const k3 = rates(plus(x, k2, h / 2)); const k4 = rates(plus(x, k3, h));
      x = x.map((value, n) => value + h / 6 * (k1[n] + 2 * k2[n] + 2 * k3[n] + k4[n]));
    }
  }
  const first = found.map(([a]) => vector(Math.sin(a), 0, -Math.cos(a)));
  const second = found.map(([a, b], i) => vector(first[i][0] + Math.sin(b), 0, first[i][2] - Math.cos(b)));
  const pull = found.map(([a, b, u, v]) => 2 * g * Math.cos(a) + 2 * u * u + v * v * Math.cos(a - b));
  const pivot = [0, 0, 0];
  return {
    up: [0, 0, 1], t,
    bodies: [{name: 'bob1', shape: {kind: 'sphere', radius: 0.08}, position: first, orientation: null}, {name: 'bob2', shape: {kind: 'sphere', radius: 0.08}, position: second, orientation: null}],
    lines: [{name: 'rods', points: first.map((place, i) => [pivot, place, second[i]])}],
    reactions: [{name: 'rod1', body: 'bob1', at: first, force: found.map(([a], i) => vector(-pull[i] * Math.sin(a), 0, pull[i] * Math.cos(a))), unit: 'N'}],
  };
}

function sphereInCylinder() {
  const t = times(8, 241);
  const R = 0.9;
  const place = t.map((s) => vector(R * Math.cos(1.6 * s), R * Math.sin(1.6 * s), 0.45 * Math.cos(1.1 * s)));
  return {
    up: [0, 0, 1], t,
    bodies: [{name: 'ball', shape: {kind: 'sphere', radius: 0.16}, position: place, orientation: t.map((s) => about([0, 0, 1], -9 * s))},
      {name: 'cylinder', shape: {kind: 'cylinder', radius: 1.06, length: 1.5, see_through: true}, position: t.map(() => [0, 0, 0]), orientation: null}],
    lines: [],
    reactions: [{name: 'wall', body: 'ball', at: place, force: t.map((s) => vector(-2.4 * Math.cos(1.6 * s), -2.4 * Math.sin(1.6 * s), 0)), unit: 'N'},
      {name: 'friction', body: 'ball', at: place, force: t.map((s) => vector(0, 0, 1 - 0.5 * Math.cos(1.1 * s))), unit: 'N'}],
  };
}

function sliderCrank() {
  const t = times(6, 181);
  const [r, l] = [0.4, 1.1];
  const pin = t.map((s) => vector(r * Math.cos(3 * s), 0, r * Math.sin(3 * s)));
  const slider = pin.map(([x, , z]) => vector(x + Math.sqrt(l * l - z * z), 0, 0));
  return {
    up: [0, 0, 1], t,
    bodies: [{name: 'pin', shape: {kind: 'point'}, position: pin, orientation: null}, {name: 'slider', shape: {kind: 'box', size: [0.3, 0.2, 0.2]}, position: slider, orientation: null}],
    lines: [{name: 'crank and rod', points: pin.map((place, i) => [[0, 0, 0], place, slider[i]])}],
    reactions: [{name: 'guide', body: 'slider', at: slider, force: t.map((s, i) => i === 90 ? null : vector(0, 0, 6 * Math.sin(3 * s))), unit: 'N'}],
  };
}

function fourBar() {
  const t = times(6, 181);
  const ground = [1.4, 0, 0];
  const [a, b, c] = [0.5, 1.2, 1.0];
  const crank = t.map((s) => vector(a * Math.cos(2 * s), 0, a * Math.sin(2 * s)));
  const rocker = crank.map(([x, , z]) => {
    const [dx, dz] = [ground[0] - x, -z];
    const d = Math.hypot(dx, dz);
    const along = (b * b - c * c + d * d) / (2 * d);
    const over = Math.sqrt(Math.max(0, b * b - along * along));
    return vector(x + along * dx / d - over * dz / d, 0, z + along * dz / d + over * dx / d);
  });
  return {
    up: [0, 0, 1], t, bodies: [{name: 'crank pin', shape: {kind: 'point'}, position: crank}, {name: 'rocker pin', shape: {kind: 'point'}, position: rocker}],
    lines: [{name: 'bars', points: crank.map((place, i) => [[0, 0, 0], place, rocker[i], ground])}],
    reactions: [{name: 'pivot', body: 'rocker pin', at: rocker, force: t.map((s) => vector(9 * Math.sin(2 * s), 0, 5 + 4 * Math.cos(4 * s))), unit: 'N'}],
  };
}

function rollingDisc() {
  const t = times(10, 241);
  const [R, lean] = [0.35, 0.5];
  const turn = (s) => 1.3 * s;
  const times4 = ([a, b, c, d], [w, x, y, z]) => [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w].map(rounded);
  const centre = t.map((s) => vector(1.1 * Math.cos(turn(s)), 1.1 * Math.sin(turn(s)), R * Math.cos(lean)));
  const contact = t.map((s) => vector((1.1 + R * Math.sin(lean)) * Math.cos(turn(s)), (1.1 + R * Math.sin(lean)) * Math.sin(turn(s)), 0));
  const orientation = t.map((s) => times4(about([0, 0, 1], turn(s)), times4(about([0, 1, 0], Math.PI / 2 - lean), about([0, 0, 1], -4.8 * s))));
  return {
    up: [0, 0, 1], t, bodies: [{name: 'disc', shape: {kind: 'cylinder', radius: R, length: 0.05}, position: centre, orientation}], lines: [],
    reactions: [{name: 'contact', body: 'disc', at: contact, force: t.map((s) => vector(-3 * Math.cos(turn(s)), -3 * Math.sin(turn(s)), 9.81)), unit: 'N'}],
  };
}

function top() {
  const t = times(5, 201);
  const lean = (s) => 0.5 + 0.12 * Math.cos(7 * s);
  const tip = t.map((s) => vector(Math.sin(lean(s)) * Math.cos(1.5 * s), Math.sin(lean(s)) * Math.sin(1.5 * s), Math.cos(lean(s))));
  return {up: [0, 0, 1], t, bodies: [{name: 'top', shape: {kind: 'sphere', radius: 0.2}, position: tip, orientation: null}], lines: [{name: 'axis', points: tip.map((place) => [[0, 0, 0], place])}], reactions: []};
}

export const motions = {double_pendulum: doublePendulum, sphere_in_cylinder: sphereInCylinder, slider_crank: sliderCrank, four_bar: fourBar, rolling_disc: rollingDisc, lagrange_top: top};
