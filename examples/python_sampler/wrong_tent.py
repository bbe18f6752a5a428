#!/usr/bin/env python3
"""tent.py with a mistake: the larger number counts for 60 % of the sum, not for half."""
import random
import sys

seed, n = int(sys.argv[1]), int(sys.argv[2])
source = random.Random(seed)
for _ in range(n):
    u, v = source.random(), source.random()
    print(1.2 * max(u, v) + 0.8 * min(u, v))
