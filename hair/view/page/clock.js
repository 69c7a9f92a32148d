// The time of the motion. It follows wall time, however many pictures a second the screen shows.

// loops: it begins again at the end.
function makeClock(duration, loops) {
  return {
    time: 0, // s, of the motion
    rate: 1, // seconds of the motion in a second
    playing: false,
    last: 0, // time of the last call, ms
    play() {
      if (this.time >= duration) this.time = 0;
      this.playing = duration > 0;
      this.last = performance.now();
    },
    stop() { this.playing = false; },
    seek(time) { this.time = Math.max(0, Math.min(duration, time)); },
    // The time now; at the end it stops.
    now(at) {
      if (this.playing) {
        this.seek(this.time + (this.rate * Math.max(0, at - this.last)) / 1000);
        this.last = at;
        if (this.time >= duration && loops) this.time = 0;
        else if (this.time >= duration) this.playing = false;
      }
      return this.time;
    },
  };
}
