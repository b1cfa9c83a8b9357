/** A mission run: drones fly a plan together, and the plan changes when something happens to them. */
@NullMarked
package org.dronemap.cognitive.operation.run;

import org.jspecify.annotations.NullMarked;
