/** Hostile input from a seed: nothing throws, nothing takes long, nothing piles up. */
@NullMarked
package org.dronemap.proxy.fuzz;

import org.jspecify.annotations.NullMarked;
