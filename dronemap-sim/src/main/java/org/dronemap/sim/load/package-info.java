/** Load for measuring: vehicles that send at a fixed pace, who watches the stream, who spoils the network between. */
@NullMarked
package org.dronemap.sim.load;

import org.jspecify.annotations.NullMarked;
