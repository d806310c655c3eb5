# SPDX-License-Identifier: BSD-3-Clause
"""A process of a parallel run, or a client of a server, is killed while intervals are extracted that are
to be saved. What is left is no file, or a whole one; the others end, and someone says what has happened.

Arguments: `rank` and mpiexec, its flag for the number of processes and pvbatch; or `client`, the server's
program and that of a client. The other modes are those of the processes that are started here.
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
# That of this process as it began: what MPI has added since would make mpiexec start nothing.
ENVIRONMENT = dict(os.environ)
LONGEST_WAIT = 240.0  # seconds, on a busy machine; an idle one takes a few
# What a process that extracts for a client leaves once its input is there.
BEGUN = "begun"
NOTE_BEGIN = """
self.GetOutput().ShallowCopy(self.GetInputDataObject(0, 0))
open({path!r}, "w").close()
"""


def extraction(half_size, begun=None):
    """Intervals of a wavelet; a file begun is made when the wavelet is there."""
    source = simple.Wavelet(WholeExtent=[-half_size, half_size] * 3)
    source.UpdatePipelineInformation()
    if begun:
        source = simple.ProgrammableFilter(
            Input=source, Script=NOTE_BEGIN.format(path=begun), CopyArrays=True)
        source.UpdatePipelineInformation()
    return interval_volume(source, "RTData", [(100.0, 140.0), (140.0, 180.0)])


def extract_and_die(folder):
    """In one of several processes: kills itself in the middle of the extraction."""
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
    """In a client: asks a server for an extraction and a file."""
    simple.Connect("localhost", int(port))
    load_plugin_on(client=True, server=True)
    volume = extraction(60, os.path.join(folder, BEGUN))
    simple.SaveData(os.path.join(folder, "saved.vtu"), proxy=volume)


def is_whole(path):
    """Whether VTK reads the file without an error, and there are cells."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetErrorCode() == 0 and reader.GetOutput().GetNumberOfCells() > 0


def check_files(checks, folder):
    left = [name for name in os.listdir(folder) if name != BEGUN]
    print("left:", left, flush=True)
    for name in left:
        checks.that(name == "saved.vtu" and is_whole(os.path.join(folder, name)), f"{name} is whole")


def check_rank(checks, mpiexec, flag, batch):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [mpiexec, flag, "2", batch, "--force-offscreen-rendering", "--symmetric", __file__,
             "extract", folder],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=LONGEST_WAIT,
            check=False, env=ENVIRONMENT)
        checks.that(run.returncode != 0, "the run has failed")
        # Messages of Open MPI 5 are broken into lines.
        said = re.search(rf"rank {KILLED_RANK}\b[^.]*signal 9 \(Killed\)",
                         " ".join(run.stdout.split()))
        checks.that(said is not None, f"the process that was killed is named: {run.stdout}")
        checks.equal(os.listdir(folder), [], "files that are left")


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
        checks.equal(server.process.wait(LONGEST_WAIT), 0, "what the server ends with")
        said = "\n".join(server.lines)
        print(said, flush=True)
        checks.that("Client connection closed" in said or "Exiting" in said, f"the server says so: {said}")
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
