@NullMarked
package org.dronemap.proxy.session;

import org.jspecify.annotations.NullMarked;
