// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { test } from "node:test";

import { FrameStore } from "../../.unit/frame_store.js";

const run = (frames, keys = ["speed"]) => ({
  dimension: 2,
  fields: keys.map((key) => ({ key })),
  frames: Array.from({ length: frames }, (_, at) => ({ time: at, count: 10, url: `${at}.bin` })),
});

function recorder(answer = (frame) => ({ bytes: 100, frame })) {
  const asked = [];
  const load = async (frame) => {
    asked.push(frame.url);
    return answer(frame);
  };
  return { asked, load };
}

test("a frame is loaded once", async () => {
  const { asked, load } = recorder();
  const store = new FrameStore(run(3), 1000, load);
  const [first, second] = await Promise.all([store.get(1), store.get(1)]);
  assert.equal(first, second);
  await store.get(1);
  assert.deepEqual(asked, ["1.bin"]);
});

test("what was not used for longest goes first", async () => {
  const { asked, load } = recorder();
  const store = new FrameStore(run(4), 250, load);
  for (const index of [0, 1, 0, 2]) await store.get(index); // 1 goes
  await store.get(0);
  await store.get(1);
  assert.deepEqual(asked, ["0.bin", "1.bin", "2.bin", "1.bin"]);
});

test("a frame larger than the budget is still given", async () => {
  const { load } = recorder(() => ({ bytes: 10_000 }));
  const store = new FrameStore(run(2), 100, load);
  assert.equal((await store.get(0)).bytes, 10_000);
});

test("a failure is not kept", async () => {
  let fails = true;
  const { load } = recorder(() => {
    if (fails) throw new Error("not yet");
    return { bytes: 1 };
  });
  const store = new FrameStore(run(1), 100, load);
  await assert.rejects(store.get(0), /not yet/);
  fails = false;
  assert.equal((await store.get(0)).bytes, 1);
});

test("more frames keep the old ones, other fields do not", async () => {
  const { asked, load } = recorder();
  const store = new FrameStore(run(1), 1000, load);
  await store.get(0);
  store.update(run(2));
  await store.get(0);
  assert.equal(asked.length, 1);
  store.update(run(2, ["speed", "pressure"]));
  await store.get(0);
  assert.equal(asked.length, 2);
});
