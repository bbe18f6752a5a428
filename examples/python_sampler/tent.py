#!/usr/bin/env python3
"""The sum of two uniform numbers has the density of a tent on [0, 2]. Tried by

    plumb verify --sampler 'python3 tent.py {seed} {n}' --density tent.csv
"""
import random
import sys

seed, n = int(sys.argv[1]), int(sys.argv[2])
source = random.Random(seed)
for _ in range(n):
    print(source.random() + source.random())
