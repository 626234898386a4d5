#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# usage: verify_elsewhere.sh KERF CASE
# Verifies a case as it is written and set up elsewhere. The commit, or without one the version of the program,
# is the text that the placement is drawn from.
commit=$(git -C "$(dirname "$0")" rev-parse HEAD 2>/dev/null) || commit=$("$1" --version)
exec "$1" verify "$2" --elsewhere "$commit"
