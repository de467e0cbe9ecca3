// Time of a motion that is played: as fast as the clock times a factor, from the beginning again at the end.

export class Player {
  /** @param {number} start @param {number} end @param {() => void} moved */
  constructor(start, end, moved) {
    this.start = start;
    this.end = end;
    this.time = start;
    this.speed = 1;
    this.playing = false;
    this.moved = moved;
    this.before = 0;
    this.request = 0;
  }

  play() {
    if (this.playing) return;
    if (this.time >= this.end) this.time = this.start;
    this.playing = true;
    this.before = performance.now();
    this.request = requestAnimationFrame((now) => this.tick(now));
    this.moved();
  }

  pause() {
    this.playing = false;
    cancelAnimationFrame(this.request);
    this.moved();
  }

  /** @param {number} now in milliseconds */
  tick(now) {
    if (!this.playing) return;
    // A page that was asleep goes on where it was.
    const passed = Math.min(Math.max(now - this.before, 0), 250) / 1000;
    this.before = now;
    this.time += passed * this.speed;
    if (this.time > this.end) this.time = this.start;
    this.moved();
    this.request = requestAnimationFrame((later) => this.tick(later));
  }

  /** @param {number} time */
  seek(time) {
    this.time = Math.min(this.end, Math.max(this.start, time));
    this.moved();
  }
}
