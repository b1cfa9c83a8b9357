package org.dronemap.ws.log;

import java.nio.file.Path;
import org.dronemap.core.time.Time;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for onboard logs. */
@Configuration(proxyBeanMethods = false)
@Import({OnboardLogController.class, OnboardLogService.class})
class OnboardLogConfiguration {
    @Bean
    OnboardLogArchive onboardLogArchive(Path dataDirectory, Time time) {
        return new OnboardLogArchive(dataDirectory.resolve("vehicle-logs"), time);
    }
}
