package org.dronemap.ws.wiring;

import org.springframework.boot.SpringBootConfiguration;
import org.springframework.boot.autoconfigure.EnableAutoConfiguration;
import org.springframework.context.annotation.Import;

/** The web server with all faces; wants a {@link House} and {@link Settings} in its context. */
@SpringBootConfiguration(proxyBeanMethods = false)
@EnableAutoConfiguration
@Import({
    ServiceConfiguration.class,
    AccessConfiguration.class,
    RestConfiguration.class,
    GrantConfiguration.class,
    StreamConfiguration.class,
    SoapConfiguration.class,
    OriginalAddressConfiguration.class,
    VirtualConfiguration.class,
    PlanConfiguration.class,
    RunConfiguration.class,
    FollowConfiguration.class
})
public class FacesApplication {}
