#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Fails unless PERCENT of the pixels of two files of RGBA bytes differ by at most LIMIT in red, green and blue.
#   compare.py FILE FILE LIMIT PERCENT
import sys

first, second = (open(name, "rb").read() for name in sys.argv[1:3])
limit, percent = int(sys.argv[3]), float(sys.argv[4])
if not first or len(first) != len(second):
    sys.exit(f"{sys.argv[1]} has {len(first)} bytes, {sys.argv[2]} {len(second)}")
worst = [max(abs(first[i + c] - second[i + c]) for c in range(3)) for i in range(0, len(first), 4)]
near = 100 * sum(difference <= limit for difference in worst) / len(worst)
print(f"{near:.2f} % of pixels within {limit}/255, the largest difference {max(worst)}/255")
sys.exit(near < percent)
