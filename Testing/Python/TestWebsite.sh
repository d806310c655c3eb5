# SPDX-License-Identifier: BSD-3-Clause
# TestWebsite.sh DIRECTORY PYTHON_PATH: builds the website in DIRECTORY and checks its links. A
# warning of Doxygen or Sphinx is an error. Skipped if a package is missing.
set -euo pipefail
. "$(dirname "$0")/../../Utilities/lib/common.sh"
. "$(dirname "$0")/../../Utilities/lib/website.sh"

error=$(check_website_packages)
if [ -n "$error" ]; then
  printf 'skipped: %s\n' "$error"
  exit 77
fi
build_website "$1/pages" "$1/site" "$source_dir/Data/Baseline" "$2"
/usr/bin/python3 "$source_dir/Documentation/site/check.py" "$1/site"
