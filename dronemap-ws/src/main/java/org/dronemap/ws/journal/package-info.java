/** How states, inputs and decisions of operations are written down, and read again to the letter. */
@NullMarked
package org.dronemap.ws.journal;

import org.jspecify.annotations.NullMarked;
