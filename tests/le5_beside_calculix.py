#!/usr/bin/env python3
"""NAFEMS LE5 by CalculiX's S8R: axial stress of the middle surface at A, and the turn of flange and web.

    tests/le5_beside_calculix.py            # needs ccx; about a minute

A Z section, 10 m long, web 2 m, flanges 1 m, 0.1 m thick, clamped, edge shears of 0.6 MN along both
flanges at the tip. With walls a thousand times stiffer across (E2, nu12 / 1000) the section keeps
its shape, which is what the reference, -108 MPa of a beam after Vlasov, presupposes.
"""
import os
import subprocess
import tempfile
from pathlib import Path

E, NU, LENGTH, WALL, SHEAR = 210e9, 0.3, 10.0, 0.1, 0.6e6
PLATES = [((0, -1, -1), (0, 1, 0), 1), ((0, 0, -1), (0, 0, 2), 2), ((0, 0, 1), (0, 1, 0), 1)]


def deck(along, across, stiffer):
    numbers, elements, webs, tips = {}, [], [], [{}, {}, {}]

    def node(plate, a, b):
        (_, y, z), (_, wy, wz), n = PLATES[plate]
        share = b / (2 * n * across)
        at = (LENGTH * a / (2 * along), y + wy * share, z + wz * share)
        return numbers.setdefault(tuple(round(x, 6) for x in at), len(numbers) + 1)

    for plate, (_, _, wide) in enumerate(PLATES):
        for i in range(along):
            for j in range(wide * across):
                ring = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
                elements.append([node(plate, 2 * i + a, 2 * j + b) for a, b in ring])
                if plate == 1:
                    webs.append(len(elements))
        for j in range(wide * across):
            for b, weight in ((0, 1), (1, 4), (2, 1)):
                n = node(plate, 2 * along, 2 * j + b)
                tips[plate][n] = tips[plate].get(n, 0) + weight / (6 * wide * across)
    shear = E / (2 + 2 * NU)
    others = NU if stiffer == 1 else 0
    lines = ['*NODE', *(f'{n},{x},{y},{z}' for (x, y, z), n in numbers.items()),
             '*ELEMENT,TYPE=S8R,ELSET=ALL',
             *(f'{i + 1},' + ','.join(map(str, e)) for i, e in enumerate(elements)),
             '*ELSET,ELSET=WEB', *(f'{i},' for i in webs), '*ELSET,ELSET=FLANGES',
             *(f'{i + 1},' for i in range(len(elements)) if i + 1 not in set(webs)),
             '*MATERIAL,NAME=M', '*ELASTIC,TYPE=ENGINEERING CONSTANTS',
             f'{E},{E * stiffer},{E},{NU / stiffer},{others},{others},{shear},{shear},', f'{shear}',
             '*ORIENTATION,NAME=F', '1,0,0,0,1,0', '*ORIENTATION,NAME=W', '1,0,0,0,0,1',
             '*SHELL SECTION,MATERIAL=M,ELSET=FLANGES,ORIENTATION=F', f'{WALL}',
             '*SHELL SECTION,MATERIAL=M,ELSET=WEB,ORIENTATION=W', f'{WALL}', '*BOUNDARY',
             *(f'{n},1,6' for (x, _, _), n in numbers.items() if x == 0),
             '*STEP', '*STATIC', '*CLOAD',
             *(f'{n},2,{-SHEAR * w:.9g}' for n, w in tips[2].items()),
             *(f'{n},2,{SHEAR * w:.9g}' for n, w in tips[0].items()),
             '*NODE FILE,OUTPUT=2D', 'U', '*END STEP']
    return numbers, '\n'.join(lines) + '\n'


def displacements(frd):
    u, on = {}, False
    for line in frd.splitlines():
        if line.startswith(' -4'):
            on = 'DISP' in line
        elif line.startswith(' -3'):
            on = False
        elif on and line.startswith(' -1'):
            u[int(line[3:13])] = [float(line[13 + 12 * k:25 + 12 * k]) for k in range(3)]
    return u


def solved(along, across, stiffer):
    numbers, text = deck(along, across, stiffer)
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, 'z.inp').write_text(text, encoding='utf-8')
        subprocess.run(['ccx', 'z'], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, 'OMP_NUM_THREADS': '1'})
        u = displacements(Path(folder, 'z.frd').read_text(encoding='utf-8'))
    at = lambda x, y, z: u[numbers[round(x, 6), float(y), float(z)]]
    step = LENGTH / along
    stress = E * (at(2.5 + step, 1, 1)[0] - at(2.5 - step, 1, 1)[0]) / (2 * step)
    web = -(at(2.5, 0, 1)[1] - at(2.5, 0, -1)[1]) / 2
    flange = at(2.5, 1, 1)[2] - at(2.5, 0, 1)[2]
    return stress / 1e6, flange / web


for along, across, stiffer in ((16, 2, 1), (32, 3, 1), (64, 6, 1), (32, 3, 1000)):
    stress, turn = solved(along, across, stiffer)
    print(f'{along} x {across} elements a flange, {stiffer} times stiffer across: '
          f'{stress:.2f} MPa, flange turns {turn:.3f} times as much as the web')
