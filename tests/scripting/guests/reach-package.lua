-- SPDX-License-Identifier: MIT
-- refused: nothing is called 'package'
package.loadlib("x", "y")
