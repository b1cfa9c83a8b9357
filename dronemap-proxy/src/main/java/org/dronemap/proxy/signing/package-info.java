/** Keys of vehicles at work: which frames speak for a drone, how what goes out is signed, and how keys change. */
@NullMarked
package org.dronemap.proxy.signing;

import org.jspecify.annotations.NullMarked;
