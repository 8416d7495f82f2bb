// What follows a change by some time: of several answers the last one's counts.
import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as wait } from "node:timers/promises";
import { afterChanges } from "../src/studio/server.js";

test("an answer that comes after the next change is dropped, also before the next request is sent", async () => {
  const answered = [];
  let number = 0;
  const change = afterChanges(60, async (signal) => {
    const own = ++number;
    await wait(30, null, { signal });
    answered.push(own);
  });
  change();
  await wait(70); // the first request is under way
  change();
  await wait(200);
  assert.deepEqual(answered, [2]);
});
