# SPDX-License-Identifier: BSD-3-Clause
"""Runs a ParaView server in a separate process on this machine, and connects a client."""

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
    """Returns the environment without variables set by the client's MPI, which would prevent mpiexec from
    starting."""
    return {name: value for name, value in os.environ.items() if not OF_A_PROCESS.match(name)}


class Server:
    """A server process with its output lines. The program may consist of several arguments, beginning with
    mpiexec."""

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
            raise RuntimeError(f"The server did not start within a minute: {self.lines}")

    def listen(self):
        for line in self.process.stdout:
            self.lines.append(line.rstrip())
            if READY in line:
                self.ready.set()


def connect(*program):
    """Returns a new server to which this client is connected. It ends with the client."""
    server = Server(*program)
    simple.Connect("localhost", server.port)
    return server


def load_plugin_on(client, server):
    """Loads the plugin into the client, the server or both."""
    path = os.environ["INTERLUME_PLUGIN"]
    if server:
        simple.LoadPlugin(path, remote=True, ns=vars(simple))
    if client:
        simple.LoadPlugin(path, remote=False, ns=vars(simple))
    assert servermanager.ActiveConnection.IsRemote()
