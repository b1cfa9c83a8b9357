/** Following a phone with one drone: a state machine, and who steers while it follows. */
@NullMarked
package org.dronemap.cognitive.operation.follow;

import org.jspecify.annotations.NullMarked;
