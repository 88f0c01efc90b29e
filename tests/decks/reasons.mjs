// Why a deck has other frequencies in its reference. Of CalculiX: what the two say of it on finer nets, with S8R,
// S6 and B32R in place of its shells and beams, which CalculiX makes solids of, and with radii as radii in both.
import { finerDeck } from "./finer_deck.mjs";
import { trussFrequencies } from "./trusses.mjs";

const mostNodes = 12000;

// One number of SECTION=CIRC is the radius, and the diameter in CalculiX.
export function withDiameters(text) {
  const lines = text.split(/\r?\n/);
  for (let i = 0; i + 1 < lines.length; ++i)
    if (/^\*BEAM SECTION.*SECTION\s*=\s*CIRC/i.test(lines[i])) {
      const sizes = lines[i + 1].split(",").map((x) => x.trim()).filter((x) => x !== "");
      if (sizes.length === 1) lines[i + 1] = `${2 * Number(sizes[0])}`;
    }
  return lines.join("\n");
}

const nodesOf = (text) => text.slice(0, text.indexOf("*ELEMENT")).split("\n").length;
const percent = (gap) => (gap === undefined ? "none" : `${(100 * gap).toPrecision(2)} %`);

// {kind, gaps: as it is, then on nets of second order as fine, halved and halved again}. `found`: frequencies of
// Plica; `again(text, of CalculiX)`: how far the furthest of the five lowest is off.
export async function reasonOf(text, worst, found, within, again) {
  const gaps = [worst], turned = withDiameters(text), bars = trussFrequencies(text);
  const done = (kind) => ({ kind, gaps: gaps.map(percent).join(", ") });
  if (bars) {
    const off = bars.slice(0, 5).map((f) => found.reduce((best, x) => Math.min(best, Math.abs(x / f - 1)), Infinity));
    gaps.push(Math.max(...off));
    return done(gaps.at(-1) < 1e-4 ? "trusses, whose bars summed up have the frequencies of Plica" : "trusses");
  }
  if (turned !== text) {
    gaps.push(await again(text, turned));
    if (gaps.at(-1) < worst / 10) return done("a radius that CalculiX takes for a diameter");
  }
  try {
    for (let halvings = 0; halvings < 3; ++halvings) {
      const finer = finerDeck(text, halvings);
      if (halvings > 0 && nodesOf(finer) > mostNodes) break;
      gaps.push(await again(finer, withDiameters(finer)));
      if (gaps.at(-1) <= within) return done("within 1 % on a finer net of S8R, S6, B32R");
    }
  } catch (error) {
    return done(`a deck that is not made finer (${error.message})`);
  }
  const known = gaps.filter((gap) => gap !== undefined);
  if (known.length === 1) return done("not solved on finer nets");
  const falls = known.length > 1 && known.at(-1) < 0.6 * known[0] && known.at(-1) <= Math.min(...known);
  return done(falls ? "nearer on every finer net, not yet within 1 %" : "not by the net");
}

// Of a listing that is not of the modes of the deck as it stands; nothing where there is no such reason.
export function reasonOfListing(text, theirs) {
  const because = (kind) => ({ kind, gaps: "" });
  if (/^\s*(SOL\s+105|PARAM[\s,]+BUCKLE)/im.test(text)) return because("a listing of buckling");
  if (/^\s*(ASET|OMIT)/im.test(text)) return because("a listing of a model reduced to a few points");
  return Math.max(...theirs) < 1e-3 ? because("a listing of rigid motions alone") : undefined;
}
