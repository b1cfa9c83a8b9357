/** A house for tests: real cloud manager, stores in memory, a vehicle that does what the test says. */
@NullMarked
package org.dronemap.ws.testserver;

import org.jspecify.annotations.NullMarked;
