package org.dronemap.ws.http;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Declares the media types of files that a REST operation takes or returns, for the OpenAPI description. */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface FileMediaTypes {
    /** Media types, any of which the body may be. */
    String[] consumes() default {};

    /** Media types, one of which the answer is. */
    String[] produces() default {};
}
