// SPDX-License-Identifier: Apache-2.0
// Holds the text of the case, which is the truth, and asks the server what it means. One question is
// under way at a time; what is entered meanwhile is asked next.

import { tell, type Answer, type Change } from "./protocol.ts";

export class Checker {
  private text_ = "";
  private version = 0; // of the text, as the user types it
  private readonly changes = new Map<string, Change>();
  private isBusy = false;
  private isStale = false;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly waiting: (() => void)[] = [];

  constructor(
    private readonly arrived: (answer: Answer) => void,
    private readonly failed: (reason: string) => void,
  ) {}

  get text(): string {
    return this.text_;
  }

  setText(text: string, delay = 0) {
    this.text_ = text;
    this.version += 1;
    this.askAfter(delay);
  }

  change(change: Change, delay = 0) {
    this.changes.set(change.path, change);
    this.askAfter(delay);
  }

  /** Resolves when the text has everything that was entered. */
  async settled(): Promise<void> {
    if (!this.isBusy && !this.isStale) return;
    if (!this.isBusy) void this.ask();
    await new Promise<void>((resolve) => this.waiting.push(resolve));
  }

  /** Replaces the text by what `make` makes of it. Nothing that is entered meanwhile is lost. */
  async rewrite(make: (text: string) => Promise<string>): Promise<void> {
    for (;;) {
      await this.settled();
      const version = this.version;
      const made = await make(this.text_);
      if (version !== this.version || this.isStale || this.isBusy) continue;
      this.setText(made);
      return this.settled();
    }
  }

  private askAfter(delay: number) {
    this.isStale = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.ask(), delay);
  }

  private async ask(): Promise<void> {
    clearTimeout(this.timer);
    if (this.isBusy) return;
    this.isBusy = true;
    while (this.isStale) {
      this.isStale = false;
      await this.askOnce();
    }
    this.isBusy = false;
    for (const resolve of this.waiting.splice(0)) resolve();
  }

  private async askOnce(): Promise<void> {
    const set = [...this.changes.values()];
    const version = this.version;
    this.changes.clear();
    try {
      const answer = await tell<Answer>("check", { text: this.text_, set });
      if (version !== this.version) {
        // The text was typed into meanwhile; the changes of the form are made in the new one.
        for (const change of set) if (!this.changes.has(change.path)) this.changes.set(change.path, change);
        this.isStale = true;
        return;
      }
      this.text_ = answer.text;
      if (!this.isStale) this.arrived(answer);
    } catch (error) {
      for (const change of set) if (!this.changes.has(change.path)) this.changes.set(change.path, change);
      this.failed((error as Error).message);
    }
  }
}
