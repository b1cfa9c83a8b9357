/** This process: what it leaves behind when it ends, that it ends when it cannot do its duty, and how its parts are. */
@NullMarked
package org.dronemap.ws.process;

import org.jspecify.annotations.NullMarked;
