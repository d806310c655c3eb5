# SPDX-License-Identifier: BSD-3-Clause
"""Runs the ParaView client on a separate display, controlled by ParaView's test player."""

import contextlib
import os
import shutil
import signal
import subprocess
from xml.sax.saxutils import quoteattr

MAXIMIZED = """<openbox_config xmlns="http://openbox.org/3.4/rc"><applications>
<application class="*" type="normal"><decor>no</decor><maximized>yes</maximized></application>
</applications></openbox_config>
"""
SHELL = "pqClientMainWindow/pythonShellDock/pythonShell/consoleWidget"


def python(code):
    """Returns the gesture that types a line into the client's Python shell."""
    return (SHELL, "executeCommand", code)


def check(widget, name, value):
    """Returns the gesture that checks a property of a widget. If it has another value, the client's exit status
    is not 0."""
    return (widget, name, value, "pqcheck")


@contextlib.contextmanager
def started(command, **options):
    """Starts a process and ends it by its id."""
    process = subprocess.Popen(command, **options)
    try:
        yield process
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait()


@contextlib.contextmanager
def display(size, folder, log):
    """Starts an X server with a window manager that maximizes windows. Yields the display name as soon as it
    accepts clients."""
    configuration = os.path.join(folder, "openbox.xml")
    with open(configuration, "w", encoding="utf-8") as file:
        file.write(MAXIMIZED)
    manager = ["openbox", "--config-file", configuration]
    reading, writing = os.pipe()
    server = ["Xvfb", "-displayfd", str(writing), "-screen", "0", size + "x24", "-noreset"]
    with started(server, pass_fds=[writing], stdout=log, stderr=log):
        os.close(writing)
        with os.fdopen(reading) as output:
            name = ":" + output.readline().strip()
        with started(manager, env={**os.environ, "DISPLAY": name}, stdout=log, stderr=log):
            yield name


def write_script(path, gestures):
    with open(path, "w", encoding="utf-8") as script:
        script.write('<?xml version="1.0" ?>\n<pqevents>\n')
        for widget, command, argument, *kind in gestures:
            tag, name = ("pqcheck", "property") if kind else ("pqevent", "command")
            script.write(f"  <{tag} object={quoteattr(widget)} {name}={quoteattr(command)}"
                         f" arguments={quoteattr(argument)} />\n")
        script.write("</pqevents>\n")


def play(gestures, folder, name, seconds, size="800x600"):
    """Plays gestures in a client with the plugin, on a screen of the given size. Returns the exit status and the
    printed lines.

    The client has its own home directory, so that it does not read settings of earlier runs or users.
    """
    script = os.path.join(folder, name + ".xml")
    write_script(script, gestures)
    home = os.path.join(folder, name + "-home")
    shutil.rmtree(home, ignore_errors=True)
    os.makedirs(home, mode=0o700)
    plugin = os.environ["INTERLUME_PLUGIN"]
    # With a space instead of =, ParaView 5.13 takes the directory for a file to open.
    command = [os.environ["INTERLUME_CLIENT"], "--dr", "--plugins=Interlume",
               "--plugin-search-paths=" + os.path.dirname(plugin), "--test-script=" + script, "--exit"]
    path = os.path.join(folder, name + ".log")
    with open(path, "w", encoding="utf-8") as log, display(size, home, subprocess.DEVNULL) as screen:
        environment = {**os.environ, "DISPLAY": screen, "HOME": home, "XDG_RUNTIME_DIR": home,
                       "LIBGL_ALWAYS_SOFTWARE": "1"}
        with started(command, env=environment, cwd=home, stdout=log, stderr=log) as client:
            try:
                status = client.wait(seconds)
            except subprocess.TimeoutExpired:
                status = f"none after {seconds} s"
    with open(path, encoding="utf-8", errors="replace") as log:
        return status, log.read().splitlines()
