# SPDX-License-Identifier: BSD-3-Clause
"""drag.py PID X1 Y1 X2 Y2: drags the mouse while the client PID works.

The mouse moves after each PAUSE of the client's processor time, or of wall time if the client is idle. Other programs
therefore hardly change the number of moves per frame.
"""

import os
import subprocess
import sys
import time

PAUSE = 0.05
MOVES = 60


def state_of(pid):
    """Returns whether the client's main thread sleeps, and the processor seconds of all its threads."""
    with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
        fields = file.read().rpartition(")")[2].split()
    return fields[0] == "S", (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def wait(pid):
    wall, (_, processor) = time.monotonic(), state_of(pid)
    while True:
        time.sleep(0.01)
        sleeps, now = state_of(pid)
        if now - processor >= PAUSE or (sleeps and time.monotonic() - wall >= PAUSE):
            return


def mouse(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True)


def main():
    pid, *numbers = map(int, sys.argv[1:])
    start, end = numbers[:2], numbers[2:]
    mouse("mousemove", *start, "sleep", 0.3, "mousedown", 1)
    for i in range(1, MOVES + 1):
        wait(pid)
        mouse("mousemove", *(round(a + (b - a) * i / MOVES) for a, b in zip(start, end)))
    wait(pid)


main()
