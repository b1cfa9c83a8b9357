/** What is written down of operations, to the letter. */
@NullMarked
package org.dronemap.ws.journal;

import org.jspecify.annotations.NullMarked;
