// SPDX-License-Identifier: Apache-2.0
// A run that goes on is asked for again and again.

const interval = 2000; // ms

/** `arrived` gets the text and says whether there is more to come; `lost` is told why nothing came. */
export function follow(arrived: (text: string) => boolean, lost: (reason: string) => void, address = "run.json") {
  const ask = async () => {
    let more = true;
    try {
      const answer = await fetch(address, { cache: "no-store" });
      if (!answer.ok) throw new Error(`answer ${answer.status}`);
      more = arrived(await answer.text());
    } catch (error) {
      lost((error as Error).message);
    }
    if (more) setTimeout(ask, interval);
  };
  setTimeout(ask, interval);
}
