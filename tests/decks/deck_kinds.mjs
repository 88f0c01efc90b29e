// What a deck is: its code, its elements, and whether it holds shells, beams, masses, springs and rigid
// elements alone.

const kinds = (...names) => new Set(names.flatMap((line) => line.split(" ")));

const light = {
  abaqus: kinds("S3 S3R S4 S4R S4R5 S6 S8 S8R S8R5 STRI3 STRI65 M3D3 M3D4 M3D6", "T2D2 T2D3 T3D2 T3D3 MASS ROTARYI U1",
    "B21 B22 B23 B21H B22H B23H B31 B32 B33 B31R B32R B33R B31H B32H B33H B31OS B32OS B33OS B31OSH B32OSH B33OSH",
    "SPRING1 SPRING2 SPRINGA DASHPOT1 DASHPOT2 DASHPOTA DCOUP3D R3D3 R3D4 RB3D2"),
  nastran: kinds("CQUAD4 CQUADR CQUAD8 CTRIA3 CTRIAR CTRIA6 CQUAD1 CQUAD2 CTRIA1 CTRIA2 CQDPLT CTRPLT CTRBSC",
    "CQDMEM CQDMEM1 CQDMEM2 CTRMEM CSHEAR CTWIST CBAR CBEAM CBEND CROD CONROD CTUBE CONM1 CONM2",
    "CMASS1 CMASS2 CMASS3 CMASS4 CELAS1 CELAS2 CELAS3 CELAS4 CBUSH CBUSH1D CVISC",
    "CDAMP1 CDAMP2 CDAMP3 CDAMP4 CDAMP5"),
};
export const isLight = (code, counts) => Object.keys(counts).every((kind) => light[code].has(kind));

// Beginnings of the names of elements of Nastran.
const elements = ("ONM ONROD QUAD TRI BAR BEAM ROD TUBE MASS ELAS BUSH SHEAR VISC DAMP QD TR HEXA TETRA PENTA PYRA " +
  "HBDY AERO IHEX WEDGE BEND FAST WELD GAP FLUID SLOT AXIF CONEAX TWIST HACA HACB INTC RAC TORDRG TRAPRG TRIARG " +
  "TRIAAX TRAPAX QUADX TRIAX IS2D8 PLST PLSN DUM BARAO BUTT SEAM RIVET EQUADF").split(" ");
const isElement = (name) => name.startsWith("C") && !/^(CORD|CAERO|CTRIAX6$)/.test(name) &&
  elements.some((beginning) => name.startsWith("C" + beginning));

const isNastran = (file, text) => !/\.inp$/i.test(file) || /^\s*(BEGIN\s+BULK|CEND)/im.test(text);

function nastranKinds(text) {
  const begin = text.search(/^\s*BEGIN/im), names = [];
  for (const line of text.slice(begin < 0 ? 0 : begin).split("\n")) {
    const name = line.slice(0, 8).split(",")[0].trim().replace("*", "").toUpperCase();
    if (isElement(name) || name.startsWith("CTRIAX")) names.push(name);
  }
  return names;
}

function abaqusKinds(text) {
  const names = [];
  let type = null;
  for (const line of text.split("\n")) {
    if (line.startsWith("**")) continue;
    if (!line.startsWith("*")) {
      if (type) names.push(type);
    } else {
      const given = line.match(/TYPE\s*=\s*([^,\s]+)/i)?.[1] ?? "?";
      type = /^\*ELEMENT\s*,/i.test(line) ? given.toUpperCase() : null;
    }
  }
  return names;
}

// {code, kinds: counts by name}, or nothing where a file has no node or no element.
export function kindsOf(file, text) {
  const code = isNastran(file, text) ? "nastran" : "abaqus";
  const node = { nastran: /^\s*GRID/im, abaqus: /^\*NODE\b(?!\s*(PRINT|FILE|OUTPUT))/im }[code];
  if (!node.test(text)) return undefined;
  const counts = {};
  for (const name of code === "nastran" ? nastranKinds(text) : abaqusKinds(text))
    counts[name] = (counts[name] ?? 0) + 1;
  return Object.keys(counts).length > 0 ? { code, kinds: counts } : undefined;
}
