# SPDX-License-Identifier: BSD-3-Clause
"""A server of ParaView's in a process of its own, on this machine, and a client's connection to it."""

import os
import re
import socket
import subprocess
import threading

from paraview import servermanager, simple

READY = "Accepting connection"
OF_A_PROCESS = re.compile("OMPI_(?!ALLOW|MCA_rmaps|MCA_btl)|PMIX_|PRTE_(?!MCA)|ORTE_")


def free_port():
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return listener.getsockname()[1]


def own_environment():
    """Without what the client's MPI has set for itself, with which mpiexec would not start."""
    return {name: value for name, value in os.environ.items() if not OF_A_PROCESS.match(name)}


class Server:
    """What the process says, line by line, and whether it still runs. The program may be several words,
    mpiexec's before its own."""

    def __init__(self, *program):
        self.port = free_port()
        self.lines = []
        self.ready = threading.Event()
        self.process = subprocess.Popen(
            [*program, "--force-offscreen-rendering", f"--server-port={self.port}"],
            env=own_environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        threading.Thread(target=self.listen, daemon=True).start()
        if not self.ready.wait(60):
            self.process.kill()
            raise RuntimeError(f"no server after a minute: {self.lines}")

    def listen(self):
        for line in self.process.stdout:
            self.lines.append(line.rstrip())
            if READY in line:
                self.ready.set()


def connect(*program):
    """A server that this client is connected to; it ends with the client."""
    server = Server(*program)
    simple.Connect("localhost", server.port)
    return server


def load_plugin_on(client, server):
    """Into the client, the server or both."""
    path = os.environ["INTERLUME_PLUGIN"]
    if server:
        simple.LoadPlugin(path, remote=True, ns=vars(simple))
    if client:
        simple.LoadPlugin(path, remote=False, ns=vars(simple))
    assert servermanager.ActiveConnection.IsRemote()
