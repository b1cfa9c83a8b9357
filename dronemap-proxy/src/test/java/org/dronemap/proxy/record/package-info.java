@NullMarked
package org.dronemap.proxy.record;

import org.jspecify.annotations.NullMarked;
