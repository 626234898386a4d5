// SPDX-License-Identifier: Apache-2.0
// Everything that needs a browser, one after the other.

import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";

import { checkFailures } from "./failures.mjs";
import { checkLive } from "./live.mjs";
import { makeSamples } from "./make_sample.mjs";
import { usePage } from "./page.mjs";
import { useSampleStudies } from "./study_page.mjs";

const folder = mkdtempSync(join(tmpdir(), "kerf-pages-"));
try {
  for (const path of makeSamples(folder)) {
    await usePage(path);
    console.log(`ok  ${basename(path)}`);
  }
  await checkFailures(folder);
  console.log("ok  pages with something wrong");
  await useSampleStudies(folder);
  console.log("ok  pages of studies");
  await checkLive();
  console.log("ok  a live page");
} finally {
  rmSync(folder, { recursive: true });
}
