// SPDX-License-Identifier: Apache-2.0
// Which frame is shown, and the passing from one to the next.

const sleep = (milliseconds: number) => new Promise((done) => setTimeout(done, milliseconds));

export class Player {
  index = 0;
  playing = false;
  framesPerSecond = 10;
  private turn = 0;
  private readonly listeners: (() => void)[] = [];

  /** `show` ends when the frame is on the screen. */
  constructor(
    public times: number[],
    private readonly show: (index: number) => Promise<void>,
  ) {}

  onChange(listener: () => void) {
    this.listeners.push(listener);
  }

  get last(): number {
    return this.times.length - 1;
  }

  get time(): number | undefined {
    return this.times[this.index];
  }

  /** Where the reader stood at the end, the end is followed. */
  setTimes(times: number[]) {
    const follow = this.index >= this.last;
    const grown = times.length !== this.times.length;
    this.times = times;
    if (grown && follow) void this.to(this.last);
    else if (this.index > this.last) void this.to(this.last);
    else this.tell();
  }

  goTo(index: number) {
    this.pause();
    void this.to(index);
  }

  /** The frame nearest to a time. */
  goToTime(time: number) {
    const distance = (index: number) => Math.abs(this.times[index] - time);
    let nearest = 0;
    for (let index = 1; index <= this.last; ++index) if (distance(index) < distance(nearest)) nearest = index;
    this.goTo(nearest);
  }

  step(by: number) {
    this.goTo(this.index + by);
  }

  toggle() {
    if (this.playing) this.pause();
    else void this.play();
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.tell();
  }

  private async play() {
    const turn = ++this.turn;
    this.playing = true;
    let next = this.index >= this.last ? 0 : this.index + 1;
    while (this.playing && turn === this.turn && next <= this.last) {
      const begin = performance.now();
      await this.to(next);
      await sleep(Math.max(0, 1000 / this.framesPerSecond - (performance.now() - begin)));
      next = this.index + 1;
    }
    if (turn === this.turn) this.pause();
  }

  private to(index: number): Promise<void> {
    this.index = Math.min(Math.max(index, 0), Math.max(this.last, 0));
    this.tell();
    return this.times.length > 0 ? this.show(this.index) : Promise.resolve();
  }

  private tell() {
    for (const listener of this.listeners) listener();
  }
}
