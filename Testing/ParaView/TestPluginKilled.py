# SPDX-License-Identifier: BSD-3-Clause
"""Kills a process of a parallel run, or a client of a server, during an extraction whose result is to be saved.
There must be no file or a complete one, the other processes must end, and the event must be reported.

Arguments: `rank` with mpiexec, its flag for the number of processes and pvbatch, or `client` with the programs of
server and client. The other modes are used by the processes started here.
"""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time

from paraview import servermanager, simple
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from plugin_testing import Checks, interval_volume, load_plugin
from server_testing import Server, load_plugin_on

KILLED_RANK = 1
# Environment at the start of this process: variables that MPI adds later would prevent mpiexec from starting.
ENVIRONMENT = dict(os.environ)
LONGEST_WAIT = 240.0  # seconds on a busy machine; an idle one takes a few
# File that a server process writes as soon as the input exists.
BEGUN = "begun"
NOTE_BEGIN = """
self.GetOutput().ShallowCopy(self.GetInputDataObject(0, 0))
open({path!r}, "w").close()
"""


def extraction(half_size, begun=None):
    """Extracts intervals of a wavelet. The file `begun` is written when the wavelet exists."""
    source = simple.Wavelet(WholeExtent=[-half_size, half_size] * 3)
    source.UpdatePipelineInformation()
    if begun:
        source = simple.ProgrammableFilter(
            Input=source, Script=NOTE_BEGIN.format(path=begun), CopyArrays=True)
        source.UpdatePipelineInformation()
    return interval_volume(source, "RTData", [(100.0, 140.0), (140.0, 180.0)])


def extract_and_die(folder):
    """Kills one of several processes during the extraction."""
    load_plugin()
    volume = extraction(30)
    extractor = volume.GetClientSideObject()

    def die(caller, _event):
        if caller.GetProgress() > 0.3:
            os.kill(os.getpid(), signal.SIGKILL)

    rank = servermanager.vtkProcessModule.GetProcessModule().GetPartitionId()
    if rank == KILLED_RANK:
        extractor.AddObserver("ProgressEvent", die)
    simple.SaveData(os.path.join(folder, "saved.pvtu"), proxy=volume)


def extract_for_client(folder, port):
    """Requests an extraction and a file from a server."""
    simple.Connect("localhost", int(port))
    load_plugin_on(client=True, server=True)
    volume = extraction(60, os.path.join(folder, BEGUN))
    simple.SaveData(os.path.join(folder, "saved.vtu"), proxy=volume)


def is_complete(path):
    """Returns whether VTK reads the file without error and it has cells."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetErrorCode() == 0 and reader.GetOutput().GetNumberOfCells() > 0


def check_files(checks, folder):
    left = [name for name in os.listdir(folder) if name != BEGUN]
    print("left:", left, flush=True)
    for name in left:
        checks.that(name == "saved.vtu" and is_complete(os.path.join(folder, name)), f"{name} is complete")


def check_rank(checks, mpiexec, flag, batch):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [mpiexec, flag, "2", batch, "--force-offscreen-rendering", "--symmetric", __file__,
             "extract", folder],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=LONGEST_WAIT,
            check=False, env=ENVIRONMENT)
        checks.that(run.returncode != 0, "the run fails")
        # Open MPI 5 breaks messages into lines.
        messages = re.search(rf"rank {KILLED_RANK}\b[^.]*signal 9 \(Killed\)",
                         " ".join(run.stdout.split()))
        checks.that(messages is not None, f"the message names the killed process: {run.stdout}")
        checks.equal(os.listdir(folder), [], "remaining files")


def check_client(checks, program, client):
    server = Server(program)
    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen(
            [client, "--force-offscreen-rendering", __file__, "ask", folder, str(server.port)],
            env=ENVIRONMENT)
        end = time.monotonic() + LONGEST_WAIT
        while not os.path.exists(os.path.join(folder, BEGUN)) and time.monotonic() < end:
            time.sleep(0.01)
        checks.that(os.path.exists(os.path.join(folder, BEGUN)), "the extraction has begun")
        process.kill()
        process.wait()
        checks.equal(server.process.wait(LONGEST_WAIT), 0, "exit code of the server")
        messages = "\n".join(server.lines)
        print(messages, flush=True)
        checks.that("Client connection closed" in messages or "Exiting" in messages,
                    f"the server reports the closed connection: {messages}")
        check_files(checks, folder)


def main():
    mode, *arguments = sys.argv[1:]
    if mode == "extract":
        extract_and_die(*arguments)
        return
    if mode == "ask":
        extract_for_client(*arguments)
        return
    checks = Checks()
    (check_rank if mode == "rank" else check_client)(checks, *arguments)
    checks.finish()


main()
