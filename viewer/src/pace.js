// SPDX-License-Identifier: GPL-3.0-or-later
// How much is drawn while something moves: less where frames take too long, all of it again when it rests.

const kSlow = 40; // milliseconds a frame; 25 frames a second look smooth
const kVerySlow = 250;
const kQuick = 20; // one frame of a common screen, seen by the next
const kQuickFrames = 20; // after which more is tried
const kRestAfter = 200; // milliseconds

/** From all to little; `pixels`: most pixels of the picture for one of the page. */
export const kPaces = [
  { pixels: 2, coarse: false },
  { pixels: 1, coarse: false },
  { pixels: 1, coarse: true },
  { pixels: 0.5, coarse: true },
];

/**
 * Keeps to a pace. Frames are timed on the graphics card, and none is begun before the last one is done, so that what is seen never
 * lags behind the hand. `apply(pace)` is called when how much is drawn changes, `request()` when a frame is due.
 */
export class Pace {
  #rest = 0;
  #slow = 0;
  #quick = 0;
  #least = 0; // level above which frames were too slow

  constructor(gl, apply, request) {
    Object.assign(this, { gl, apply, request });
    this.slow = kSlow;
    this.level = 0; // while moving
    this.moving = false;
    this.applied = kPaces[0];
  }

  /** Something begins to move; end() says when it stopped. */
  begin() {
    clearTimeout(this.#rest);
    this.#rest = 0;
    this.moving = true;
    this.#use(this.level);
  }

  end() {
    clearTimeout(this.#rest);
    this.#rest = setTimeout(() => {
      this.rest();
      this.request();
    }, kRestAfter);
  }

  /** A step of something that moves, say by a slider. */
  nudge() {
    this.begin();
    this.end();
  }

  /** Nothing moves: draw all. */
  rest() {
    clearTimeout(this.#rest);
    this.#rest = 0;
    this.moving = false;
    this.#use(0);
  }

  /** Another model, or another part of it, is shown: try more again. */
  forget() {
    this.#least = 0;
    this.#slow = 0;
  }

  #use(level) {
    if (kPaces[level] === this.applied) return;
    this.applied = kPaces[level];
    this.apply(this.applied);
  }

  /** Is the last frame still being drawn? */
  get busy() {
    return this.sync !== undefined;
  }

  /** A frame was handed over that was begun at this time. */
  drawn(begun) {
    if (!this.moving || this.busy || this.gl.isContextLost()) return;
    this.sync = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!this.sync) {
      this.sync = undefined;
      return;
    }
    this.gl.flush();
    const watch = () => {
      const { gl, sync } = this;
      const isDone = gl.isContextLost() || gl.getSyncParameter(sync, gl.SYNC_STATUS) === gl.SIGNALED;
      if (!isDone) return void requestAnimationFrame(watch);
      gl.deleteSync(sync);
      this.sync = undefined;
      this.took(performance.now() - begun);
    };
    requestAnimationFrame(watch);
  }

  /** A frame took so many milliseconds. */
  took(cost) {
    this.cost = cost;
    this.#slow = cost > this.slow ? this.#slow + 1 : 0;
    this.#quick = cost < kQuick ? this.#quick + 1 : 0;
    if ((this.#slow >= 2 || cost > kVerySlow) && this.level + 1 < kPaces.length) {
      this.#least = this.level + 1;
      this.#change(this.level + 1);
    } else if (this.#quick >= kQuickFrames && this.level > this.#least) {
      this.#change(this.level - 1);
    }
  }

  #change(level) {
    this.level = level;
    this.#slow = 0;
    this.#quick = 0;
    if (this.moving) this.#use(level);
  }
}
