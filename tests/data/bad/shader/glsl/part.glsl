// SPDX-License-Identifier: MIT
// How strong it is.
float strength()
{
    return FACTOR * 2.0;
}
