// Which points nobody beats.

import {isNumber} from '../format.js';

/**
 * The points that no other one beats: none has both coordinates as small, and one of them smaller. Points that are alike in
 * both are all kept. Sorted by x, so y falls from one to the next.
 * @template T
 * @param {T[]} points
 * @param {(point: T) => any} x
 * @param {(point: T) => any} y
 * @returns {T[]}
 */
export function paretoFront(points, x, y) {
  const candidates = points.filter((point) => isNumber(x(point)) && isNumber(y(point)))
    .sort((a, b) => x(a) - x(b) || y(a) - y(b));
  const front = [];
  let best = Infinity;   // the smallest y at a smaller x
  let sameX = NaN;
  let bestHere = Infinity;  // the smallest y at this x, which is the first one
  for (const point of candidates) {
    if (x(point) !== sameX) {
      best = Math.min(best, bestHere);
      sameX = x(point);
      bestHere = y(point);
    }
    if (y(point) === bestHere && y(point) < best) front.push(point);
  }
  return front;
}
