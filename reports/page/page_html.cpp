#include "reports/page/page_html.h"

#include "reports/page/page_files.h"
#include "reports/page/page_template.h"
#include "reports/page/series_styles.h"
#include "reports/text/xml.h"

namespace plumb::reports {

std::string page_html(std::string_view title, std::string_view data) {
    const std::string heading = escaped(title), style = std::string(page::style()) + series_css();
    return filled(page::document(), {{"title", heading},
                                     {"style", style},
                                     {"bibliography", page::bibliography()},
                                     {"data", data},
                                     {"licences", page::licences()},
                                     {"d3", page::d3()},
                                     {"plot", page::plot()},
                                     {"script", page::script()}});
}

}  // namespace plumb::reports
