#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The joint force of the steel slider-crank of Mukras et al. (2010) over a
revolution, ideal joint and clearances of 0.5 um and 5 mm, as in their figure 7.

Run the three cases, then print the table (or write it as CSV with -o):

    for case in ideal_literal 0.5um_literal 5mm_literal; do
      scripts/run prm/mukras2010_steel_$case.prm
    done
    doc/figure_7.py output

With --reading half_length, the three cases of that name. The peak is that of all
samples, of which the file of the 5 mm case has 1440 and the others 72. Needs nothing but Python.
"""
import argparse
import csv
import os
import sys

CASES = (('ideal [N]', 'mukras2010_steel_ideal_'),
         ('0.5 um [N]', 'mukras2010_steel_0.5um_'),
         ('5 mm [N]', 'mukras2010_steel_5mm_'))


def forces(directory):
    """Crank angle [deg] -> force [N] of the crank pin."""
    path = os.path.join(directory, 'crank_pin', 'duty_cycle_0000.csv')
    try:
        with open(path, encoding='utf-8') as file:
            lines = [line for line in file if not line.startswith('#')]
    except OSError as error:
        sys.exit(f'{path}: {error.strerror}. Run the case first; see --help.')
    return {round(float(row['phase [deg]']), 3): float(row['force [N]'])
            for row in csv.DictReader(lines)}


def main():
    """Read the three cases and write the table."""
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('outputs', help='directory that holds the three outputs')
    parser.add_argument('--reading', default='literal',
                        choices=('literal', 'half_length'),
                        help='of the printed lengths (default: literal)')
    parser.add_argument('-o', metavar='FILE', help='write CSV to this file')
    parser.add_argument('--every', type=float, default=10., metavar='DEG',
                        help='crank angles to show (default: 10 deg)')
    arguments = parser.parse_args()

    columns = [forces(os.path.join(arguments.outputs,
                                   name + arguments.reading))
               for _, name in CASES]
    angles = [angle for angle in sorted(set.intersection(*map(set, columns)))
              if abs(angle / arguments.every - round(angle / arguments.every))
              < 1e-6]
    header = ['crank angle [deg]'] + [title for title, _ in CASES]
    rows = [[f'{angle:g}'] + [f'{column[angle]:.2f}' for column in columns]
            for angle in angles]
    summary = [['peak'] + [f'{max(column.values()):.2f}' for column in columns],
               ['mean'] + [f'{sum(column.values()) / len(column):.2f}'
                           for column in columns]]
    if arguments.o:
        with open(arguments.o, 'w', encoding='utf-8', newline='') as file:
            csv.writer(file).writerows([header] + rows)
        return
    for row in [header] + rows + summary:
        print('  '.join(cell.rjust(17) for cell in row))


if __name__ == '__main__':
    main()
